#include "render/integrator/integrators.h"
#include "tests/support/tiny_rooms.h"

#include <catch2/catch.hpp>

#include <barrier>
#include <optional>
#include <thread>

using namespace hipmap;

namespace {

/// A team of threads.
class Team {
  public:
    explicit Team(std::size_t count) : barrier_(static_cast<std::ptrdiff_t>(count)), parts_(count)
    {
    }

    PilotTeam member(std::size_t rank)
    {
        return {rank, parts_.size(), [this, rank](std::span<const std::byte> own, std::size_t) {
                    parts_[rank].assign(own.begin(), own.end());
                    barrier_.arrive_and_wait();
                    std::vector<std::byte> all;
                    for (const std::vector<std::byte>& part : parts_)
                        all.insert(all.end(), part.begin(), part.end());
                    barrier_.arrive_and_wait();
                    return all;
                }};
    }

  private:
    std::barrier<> barrier_;
    std::vector<std::vector<std::byte>> parts_;
};

/// A glass ball in a room that a lamp lights through a hole of its own, so that both guides learn.
Scene room()
{
    Scene scene = tiny::room();
    TriangleMesh ball = tiny::uv_sphere(16, 8);
    tiny::scale(ball, 0.1f);
    tiny::move(ball, {0.2f, -0.3f, -0.1f});
    tiny::add(scene, ball, tiny::glass(1.5f));
    TriangleMesh far = tiny::floor_at(-3, 2);
    tiny::add(scene, far, tiny::diffuse(Rgb(0.5f)));
    TriangleMesh lamp = tiny::floor_at(-1, -0.5f);
    tiny::add(scene, lamp, tiny::emissive(Rgb(50)));
    return scene;
}

struct Pilots {
    double mean = 0;
    std::uint64_t allocation = 0;
    double variance = 0, variance_aimed = 0;

    bool operator==(const Pilots&) const = default;
};

Pilots find(const RenderScene& scene, const PilotControl& pilots)
{
    RenderOptions options;
    options.integrator = Integrator::progressive;
    options.width = 24;
    options.height = 17;
    options.photons = 20'000;
    RenderStatistics statistics;
    const PassSource source = make_pass_source(scene, options, statistics, nullptr, pilots);
    return {source.pilot_mean, source.allocation, statistics.guided_variance,
            statistics.guided_variance_aimed};
}

/// What each member of a team found.  stopped: the one that was told to stop; none: no one was.
std::vector<Pilots> find_together(const RenderScene& scene, std::size_t count,
                                  std::optional<std::size_t> stopped = {})
{
    Team team(count);
    std::vector<Pilots> out(count);
    std::vector<std::thread> threads;
    for (std::size_t rank = 0; rank < count; ++rank)
        threads.emplace_back([&, rank] {
            const std::atomic<bool> stop = rank == stopped;
            out[rank] = find(scene, {&stop, {}, team.member(rank)});
        });
    for (std::thread& thread : threads)
        thread.join();
    return out;
}

} // namespace

TEST_CASE("pilot team: each member finds what one process finds", "[integrator]")
{
    const auto ready = tiny::ready(room());
    const Pilots alone = find(*ready->render, {});
    CHECK(alone.variance < 1);
    CHECK(alone.mean > 0);
    for (const std::size_t count : {2, 3, 19}) // more than the pilot has rows
        CHECK(find_together(*ready->render, count) == std::vector(count, alone));
}

TEST_CASE("pilot team: a stop of one member ends the pilots of all members", "[integrator]")
{
    const auto ready = tiny::ready(room());
    for (const Pilots& found : find_together(*ready->render, 3, 1))
        CHECK(found.mean == 0);
}
