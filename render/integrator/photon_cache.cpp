#include "render/integrator/photon_cache.h"

#include <utility>

namespace hipmap {

namespace {

void add(const KindStatistics& made, KindStatistics& sum)
{
    const std::uint64_t stored = sum.stored + made.stored;
    const SearchStatistics searches = sum.searches;
    const LevelStatistics level_searches = sum.level_searches;
    sum = made;
    sum.stored = stored;
    sum.searches = searches;
    sum.level_searches = level_searches;
}

void add_photons(const RenderStatistics& made, RenderStatistics& sum)
{
    sum.emitted += made.emitted;
    sum.aimed += made.aimed;
    sum.dropped_photons += made.dropped_photons;
    sum.cut_paths += made.cut_paths;
    sum.volume_photons += made.volume_photons;
    sum.power = made.power;
    add(made.caustic, sum.caustic);
    add(made.global, sum.global);
    add(made.indirect, sum.indirect);
    add(made.glossy, sum.glossy);
}

void add_seconds(const RenderStatistics& made, RenderStatistics& sum)
{
    sum.seconds_photons += made.seconds_photons;
    sum.seconds_maps += made.seconds_maps;
    sum.processor_photons += made.processor_photons;
    sum.processor_maps += made.processor_maps;
}

/// Takes the maps of a pass of the previous scene out of the cache; empty ones if there are none.
ProgressiveMaps take_previous(PhotonCache& cache, std::uint64_t pass)
{
    const auto found = cache.previous.find(pass);
    if (found == cache.previous.end())
        return {};
    ProgressiveMaps out = std::move(*found->second.maps);
    cache.bytes -= out.bytes();
    cache.previous.erase(found);
    return out;
}

void count_taken_over(const ProgressiveMaps& maps, PhotonCache& cache)
{
    for (const ChosenMaps* kind : {&maps.caustic, &maps.global, &maps.indirect, &maps.glossy}) {
        const PhotonMaps& shared = shared_maps(*kind);
        cache.taken_over += shared.taken_over;
        cache.built += shared.maps.size() - shared.taken_over;
    }
}

} // namespace

std::size_t ProgressiveMaps::bytes() const
{
    std::size_t out = bytes_of(caustic) + bytes_of(global) + bytes_of(indirect) + bytes_of(glossy);
    if (volume)
        out += volume->photons.size() * (sizeof(VolumePhoton) + sizeof(float) + sizeof(glm::vec3)) +
               volume->nodes.size() * sizeof(VolumeMap::Node);
    return out;
}

void change_scene(PhotonCache& cache)
{
    cache.previous = std::move(cache.passes);
    cache.passes.clear();
    cache.radii = nullptr;
    cache.bytes = 0;
    for (const auto& [number, pass] : cache.previous)
        cache.bytes += pass.maps->bytes();
}

std::shared_ptr<const ProgressiveMaps>
maps_of_pass(PhotonCache* cache, std::uint64_t pass, RenderStatistics& statistics,
             const std::function<ProgressiveMaps(ProgressiveMaps*, RenderStatistics&)>& make)
{
    if (cache != nullptr)
        if (const auto found = cache->passes.find(pass); found != cache->passes.end()) {
            cache->served += pass == kPilotPass ? 0 : 1;
            add_photons(found->second.made, statistics);
            return found->second.maps;
        }
    PhotonCache::Pass made;
    {
        const bool keeps = cache != nullptr && cache->most > 0;
        ProgressiveMaps previous = keeps ? take_previous(*cache, pass) : ProgressiveMaps();
        made.maps = std::make_shared<ProgressiveMaps>(make(keeps ? &previous : nullptr, made.made));
    }
    add_photons(made.made, statistics);
    add_seconds(made.made, statistics);
    merge(statistics.seen, std::exchange(made.made.seen, {})); // of this image alone
    if (cache != nullptr)
        count_taken_over(*made.maps, *cache);
    const std::size_t bytes = made.maps->bytes();
    if (cache != nullptr && cache->bytes + bytes <= cache->most) {
        cache->bytes += bytes;
        cache->passes[pass] = made;
    }
    return made.maps;
}

} // namespace hipmap
