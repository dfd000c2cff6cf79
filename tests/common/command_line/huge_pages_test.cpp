#include <catch2/catch.hpp>

#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <new>

namespace {

constexpr std::size_t kHugePage = std::size_t{1} << 21;

int asked = 0;

} // namespace

TEST_CASE("large arrays begin at a huge page, whatever their size", "[command_line]")
{
    for (const std::size_t size : {16 * kHugePage, 16 * kHugePage + 1, 17 * kHugePage - 1}) {
        const std::unique_ptr<char[]> bytes(new char[size]);
        CHECK(reinterpret_cast<std::uintptr_t>(bytes.get()) % kHugePage == 0);
        std::memset(bytes.get(), 1, size);
        CHECK(bytes[size - 1] == 1);
    }
    CHECK(std::unique_ptr<char[]>(new char[0]) != nullptr);
}

TEST_CASE("operator new asks the handler until there is memory, or throws", "[command_line]")
{
    volatile std::size_t too_much = std::numeric_limits<std::ptrdiff_t>::max() / 2;
    CHECK_THROWS_AS(::operator new(too_much), std::bad_alloc);
    const std::new_handler before = std::set_new_handler([] {
        if (++asked == 3)
            throw std::bad_alloc();
    });
    CHECK_THROWS_AS(::operator new(too_much), std::bad_alloc);
    CHECK(asked == 3);
    std::set_new_handler(before);
    CHECK(::operator new(too_much, std::nothrow) == nullptr);
}
