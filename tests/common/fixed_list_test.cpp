#include "common/fixed_list.h"

#include <catch2/catch.hpp>

using namespace hipmap;

namespace {

/// Counts how many of it were made by default.
struct Counted {
    static inline int made = 0;
    int value = 0;

    Counted() { ++made; }
    explicit Counted(int of) : value(of) {}
};

} // namespace

TEST_CASE("fixed_list: values come back last first")
{
    FixedList<int, 3> list;
    CHECK(list.empty());
    for (const int value : {4, 5, 6})
        list.push(value);
    REQUIRE(list.size() == 3);
    CHECK(list[0] == 4);
    CHECK(list.pop() == 6);
    CHECK(list.pop() == 5);
    list.push(7);
    CHECK(list[1] == 7);
    list.keep_first();
    CHECK(list.pop() == 4);
    CHECK(list.empty());
}

TEST_CASE("fixed_list: only values that it holds are made")
{
    FixedList<Counted, 20> list;
    list.push(Counted(8));
    CHECK(list[0].value == 8);
    CHECK(Counted::made == 0);
}
