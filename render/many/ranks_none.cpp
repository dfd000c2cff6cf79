#include "common/input_error.h"
#include "render/many/ranks.h"

namespace hipmap {

struct Ranks::Mute {};

Ranks::Ranks()
{
    throw InputError("--mpi: this render was built without MPI; install libopenmpi-dev and build "
                     "hipmap again");
}

Ranks::~Ranks() = default;

// The rest is never called: there is no object.

void Ranks::together(const std::function<void()>& body)
{
    body();
}

std::uint64_t Ranks::from_lead(std::uint64_t value)
{
    return value;
}

void Ranks::serve(const std::function<std::optional<std::uint64_t>(int, bool)>& /*next*/) {}

std::optional<std::uint64_t> Ranks::ask(bool /*stopped*/)
{
    return std::nullopt;
}

void Ranks::wait() {}

void Ranks::add_up(std::span<std::int64_t> /*sums*/) {}

std::vector<std::vector<std::uint64_t>> Ranks::gather(const std::vector<std::uint64_t>& words)
{
    return {words};
}

std::vector<std::byte> Ranks::join(std::span<const std::byte> own, std::size_t /*element*/)
{
    return {own.begin(), own.end()};
}

void Ranks::abort(const std::string& /*why*/) {}

} // namespace hipmap
