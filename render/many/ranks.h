#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hipmap {

/// The processes that render one image together, started by mpirun: one leads, the others work.
/// All calls are made by all of them in the same order, from one thread each, but for `serve` and
/// `ask`.  While an object lives, only the lead prints.  One object in a process.
class Ranks {
  public:
    /// Joins the other processes.  Throws InputError if hipmap was built without MPI, or MPI cannot
    /// be used.
    Ranks();
    /// Leaves them, once all do.
    ~Ranks();
    Ranks(const Ranks&) = delete;
    Ranks& operator=(const Ranks&) = delete;

    int count() const { return count_; }
    int rank() const { return rank_; }
    bool leads() const { return rank_ == 0; }

    /// Runs `body` in each process.  If it throws in some, this throws in all: on the lead what the
    /// first of them threw, so that it is printed once.
    void together(const std::function<void()>& body);
    /// Returns the lead's value.
    std::uint64_t from_lead(std::uint64_t value);

    /// On the lead, while its other threads render: answers the questions of the workers by
    /// next(rank, stopped) until each was answered by nothing.
    void serve(const std::function<std::optional<std::uint64_t>(int rank, bool stopped)>& next);
    /// On a worker: asks the lead for a number.  stopped: whether this process is to stop.
    std::optional<std::uint64_t> ask(bool stopped);

    /// Waits for all, without use of the processor.
    void wait();
    /// Adds the sums of all processes into those of the lead.  Afterwards the sums of the other
    /// processes are unspecified.
    void add_up(std::span<std::int64_t> sums);
    /// Sends the words of each process to the lead, and returns them there; nothing on workers.
    std::vector<std::vector<std::uint64_t>> gather(const std::vector<std::uint64_t>& words);
    /// Returns the bytes of all processes, by rank, in each.  own: of some elements, each of so
    /// many bytes.
    std::vector<std::byte> join(std::span<const std::byte> own, std::size_t element);

    /// Ends all processes at once, for a failure of one that the others do not wait for.  why: one
    /// line for people.  Returns only if a failure has already ended all of them together.
    void abort(const std::string& why);

  private:
    struct Mute;
    int count_ = 1, rank_ = 0;
    bool failed_ = false; ///< all know of a failure
    std::unique_ptr<Mute> mute_;
};

/// Runs `body` in each process as Ranks::together does.  ranks: null: there is one process.
inline void together(Ranks* ranks, const std::function<void()>& body)
{
    if (ranks != nullptr)
        ranks->together(body);
    else
        body();
}

} // namespace hipmap
