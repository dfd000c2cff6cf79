#include "render/photons/seen_classes.h"

#include "common/math/random.h"

#include <algorithm>
#include <utility>

namespace hipmap {

namespace {

/// The most units that a photon counts, so that sums do not overflow.
constexpr double kMostUnits = 0x1p40;

/// Paths of a class that one thread counts each; of the others one of kEvery.
constexpr std::uint32_t kEach = 64, kEvery = 16;

std::uint32_t added(std::uint32_t paths, std::uint32_t more)
{
    return std::min(paths + more, SeenClasses::kMostPaths);
}

} // namespace

void merge(SeenClasses& into, const SeenClasses& from)
{
    into.passes += from.passes;
    into.worth += from.worth;
    into.classes.resize(std::max(into.classes.size(), from.classes.size()));
    for (std::size_t i = 0; i < from.classes.size(); ++i) {
        SeenClasses::Class& sum = into.classes[i];
        sum.paths = added(sum.paths, from.classes[i].paths);
        sum.light = std::min(sum.light, from.classes[i].light);
        sum.worth += from.classes[i].worth;
    }
    into.lights.resize(std::max(into.lights.size(), from.lights.size()));
    for (std::size_t i = 0; i < from.lights.size(); ++i) {
        SeenClasses::OfLight& sum = into.lights[i];
        sum.paths = added(sum.paths, from.lights[i].paths);
        sum.caustic = std::max(sum.caustic, from.lights[i].caustic);
        sum.global = std::max(sum.global, from.lights[i].global);
    }
}

std::uint64_t count_paths(const SeenClasses& classes)
{
    std::uint64_t sum = 0;
    for (const SeenClasses::OfLight& light : classes.lights)
        sum += light.paths;
    return sum;
}

ClassCounter::ClassCounter(const SeenSurfaces& seen) : seen_(seen)
{
    counts_.classes.resize(SeenClasses::kClasses);
}

void ClassCounter::begin_path(std::size_t light, const Rgb& power)
{
    ++path_;
    path_counted_ = entered_ = false;
    if (lights_.empty() || lights_.back().light != light)
        lights_.push_back({static_cast<std::uint32_t>(light)});
    LightRun& run = lights_.back();
    run.largest = std::max(run.largest, sum_of_channels(power));
}

void ClassCounter::enter_class(FaceId first_specular, bool caustic)
{
    entered_ = true;
    class_counted_ = false;
    specular_ = first_specular;
    caustic_ = caustic;
    const ObjectId object = first_specular == kNone ? kNone : seen_.mesh.object_of(first_specular);
    const std::uint64_t origin = std::uint64_t{lights_.back().light} << 32 | object;
    place_ = mix_bits(mix_bits(origin) + (caustic ? 1 : 0)) % SeenClasses::kClasses;
    const bool each = counts_.classes[place_].paths < kEach;
    stands_for_ = each ? 1 : path_ % kEvery == 0 ? kEvery : 0;
}

void ClassCounter::add(const Photon& photon, FaceId first_specular, bool caustic)
{
    if (!entered_ || specular_ != first_specular || caustic_ != caustic)
        enter_class(first_specular, caustic);
    if (stands_for_ == 0)
        return;
    const SeenRegions& regions = caustic ? seen_.caustic : seen_.global;
    const MapId map = seen_.partition.map_of(photon.face);
    const std::uint32_t region =
        regions.region_at(SeenRegions::side_of(map, photon.side), photon.position);
    if (region == SeenRegions::kNoRegion)
        return;
    const double units =
        sum_of_channels(photon.power) * double{regions.regions[region].worth} / seen_.unit;
    const std::uint64_t worth =
        stands_for_ * static_cast<std::uint64_t>(std::min(units + 0.5, kMostUnits));
    SeenClasses::Class& of = counts_.classes[place_];
    of.light = std::min(of.light, lights_.back().light);
    of.worth += worth;
    counts_.worth += worth;
    if (!std::exchange(class_counted_, true))
        of.paths += stands_for_;
    if (!std::exchange(path_counted_, true))
        lights_.back().paths += stands_for_;
}

void ClassCounter::add_to(SeenClasses& into) const
{
    merge(into, counts_);
    for (const LightRun& run : lights_) {
        into.lights.resize(std::max<std::size_t>(into.lights.size(), std::size_t{run.light} + 1));
        SeenClasses::OfLight& light = into.lights[run.light];
        light.paths = added(light.paths, run.paths);
        light.caustic = std::max(light.caustic, run.largest);
        light.global = std::max(light.global, run.largest);
    }
}

} // namespace hipmap
