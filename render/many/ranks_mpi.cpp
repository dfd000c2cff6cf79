#include "common/input_error.h"
#include "render/many/ranks.h"

#include <fcntl.h>
#include <mpi.h>
#include <unistd.h>

#include <chrono>
#include <cstdio>
#include <exception>
#include <thread>

namespace hipmap {

namespace {

constexpr int kQuestion = 1, kAnswer = 2; // tags
constexpr int kLead = 0;
/// Answer to a worker when no pass is left for it.
constexpr std::uint64_t kNothing = ~std::uint64_t{0};
/// The numbers that are added up at once: 8 MiB, far below the largest count of MPI.
constexpr std::size_t kChunk = std::size_t{1} << 20;

/// Between looks for a message: MPI's own waiting would take a processor that renders.
void nap()
{
    std::this_thread::sleep_for(std::chrono::microseconds(500));
}

void finish(MPI_Request& request)
{
    for (int done = 0; done == 0;) {
        MPI_Test(&request, &done, MPI_STATUS_IGNORE);
        if (done == 0)
            nap();
    }
}

/// How many elements each process has, and where those of each begin in what all have, with the
/// end.
struct Shares {
    std::vector<int> sizes, first;
};

/// own: elements of this process.
Shares shares_of_all(std::size_t own, int processes)
{
    const auto mine = static_cast<int>(own);
    Shares out;
    out.sizes.resize(static_cast<std::size_t>(processes));
    out.first.resize(out.sizes.size() + 1);
    MPI_Allgather(&mine, 1, MPI_INT, out.sizes.data(), 1, MPI_INT, MPI_COMM_WORLD);
    for (std::size_t i = 0; i < out.sizes.size(); ++i)
        out.first[i + 1] = out.first[i] + out.sizes[i];
    return out;
}

/// Text of a failure as words, one character each; empty: none.
std::vector<std::uint64_t> words_of(const std::string& text)
{
    return {text.begin(), text.end()};
}

std::string text_of(const std::vector<std::uint64_t>& words)
{
    std::string out;
    for (const std::uint64_t word : words)
        out += static_cast<char>(word);
    return out;
}

} // namespace

/// Sends what a worker prints nowhere, to the end of the process: the lead prints its last line.
struct Ranks::Mute {
    const int error = ::dup(STDERR_FILENO);

    Mute()
    {
        const int nowhere = ::open("/dev/null", O_WRONLY);
        ::dup2(nowhere, STDOUT_FILENO);
        ::dup2(nowhere, STDERR_FILENO);
        ::close(nowhere);
    }
    /// Lets it print on standard error again.
    void end() const { ::dup2(error, STDERR_FILENO); }
};

Ranks::Ranks()
{
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_SERIALIZED, &provided);
    MPI_Comm_size(MPI_COMM_WORLD, &count_);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    if (!leads())
        mute_ = std::make_unique<Mute>();
    if (provided < MPI_THREAD_SERIALIZED) {
        MPI_Finalize();
        throw InputError("--mpi: this MPI serves no program with threads "
                         "(MPI_THREAD_SERIALIZED); use another one, such as Open MPI");
    }
}

Ranks::~Ranks()
{
    MPI_Finalize();
}

void Ranks::together(const std::function<void()>& body)
{
    std::exception_ptr own;
    std::string why;
    try {
        body();
    } catch (const std::exception& error) {
        own = std::current_exception();
        why = *error.what() != '\0' ? error.what() : "unknown failure";
    }
    wait();
    std::string first;
    for (const std::vector<std::uint64_t>& words : gather(words_of(why)))
        if (first.empty())
            first = text_of(words);
    failed_ = from_lead(first.empty() ? 0 : 1) != 0;
    if (!failed_)
        return;
    if (own)
        std::rethrow_exception(own);
    throw InputError(leads() ? first : "another process failed");
}

std::uint64_t Ranks::from_lead(std::uint64_t value)
{
    MPI_Bcast(&value, 1, MPI_UINT64_T, kLead, MPI_COMM_WORLD);
    return value;
}

void Ranks::serve(const std::function<std::optional<std::uint64_t>(int, bool)>& next)
{
    for (int left = count_ - 1; left > 0;) {
        int there = 0;
        MPI_Status status;
        MPI_Iprobe(MPI_ANY_SOURCE, kQuestion, MPI_COMM_WORLD, &there, &status);
        if (there == 0) {
            nap();
            continue;
        }
        std::uint64_t stopped = 0;
        MPI_Recv(&stopped, 1, MPI_UINT64_T, status.MPI_SOURCE, kQuestion, MPI_COMM_WORLD,
                 MPI_STATUS_IGNORE);
        const std::uint64_t answer = next(status.MPI_SOURCE, stopped != 0).value_or(kNothing);
        left -= answer == kNothing ? 1 : 0;
        MPI_Send(&answer, 1, MPI_UINT64_T, status.MPI_SOURCE, kAnswer, MPI_COMM_WORLD);
    }
}

std::optional<std::uint64_t> Ranks::ask(bool stopped)
{
    const std::uint64_t question = stopped ? 1 : 0;
    std::uint64_t answer = 0;
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Irecv(&answer, 1, MPI_UINT64_T, kLead, kAnswer, MPI_COMM_WORLD, &request);
    MPI_Send(&question, 1, MPI_UINT64_T, kLead, kQuestion, MPI_COMM_WORLD);
    finish(request);
    if (answer == kNothing)
        return std::nullopt;
    return answer;
}

void Ranks::wait()
{
    MPI_Request request = MPI_REQUEST_NULL;
    MPI_Ibarrier(MPI_COMM_WORLD, &request);
    finish(request);
}

void Ranks::add_up(std::span<std::int64_t> sums)
{
    for (std::size_t at = 0; at < sums.size(); at += kChunk) {
        std::int64_t* const chunk = sums.data() + at;
        const auto size = static_cast<int>(std::min(kChunk, sums.size() - at));
        MPI_Reduce(leads() ? MPI_IN_PLACE : chunk, leads() ? chunk : nullptr, size, MPI_INT64_T,
                   MPI_SUM, kLead, MPI_COMM_WORLD);
    }
}

std::vector<std::vector<std::uint64_t>> Ranks::gather(const std::vector<std::uint64_t>& words)
{
    const auto [sizes, first] = shares_of_all(words.size(), count_);
    std::vector<std::uint64_t> all(leads() ? static_cast<std::size_t>(first.back()) : 0);
    MPI_Gatherv(words.data(), sizes[static_cast<std::size_t>(rank_)], MPI_UINT64_T, all.data(),
                sizes.data(), first.data(), MPI_UINT64_T, kLead, MPI_COMM_WORLD);
    std::vector<std::vector<std::uint64_t>> out;
    for (std::size_t i = 0; leads() && i < sizes.size(); ++i)
        out.emplace_back(all.begin() + first[i], all.begin() + first[i + 1]);
    return out;
}

std::vector<std::byte> Ranks::join(std::span<const std::byte> own, std::size_t element)
{
    wait();
    MPI_Datatype type = MPI_DATATYPE_NULL;
    MPI_Type_contiguous(static_cast<int>(element), MPI_BYTE, &type);
    MPI_Type_commit(&type);
    const auto [sizes, first] = shares_of_all(own.size() / element, count_);
    std::vector<std::byte> all(static_cast<std::size_t>(first.back()) * element);
    MPI_Allgatherv(own.data(), sizes[static_cast<std::size_t>(rank_)], type, all.data(),
                   sizes.data(), first.data(), type, MPI_COMM_WORLD);
    MPI_Type_free(&type);
    return all;
}

void Ranks::abort(const std::string& why)
{
    if (failed_)
        return;
    if (mute_)
        mute_->end();
    std::fprintf(stderr, "error: rank %d: %s\n", rank_, why.c_str());
    std::fflush(nullptr);
    MPI_Abort(MPI_COMM_WORLD, 1);
}

} // namespace hipmap
