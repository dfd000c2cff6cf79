#include "render/settings.h"

#include "common/partition/partition_file.h"
#include "common/scene/fingerprint.h"

#include <charconv>
#include <cstdio>
#include <string_view>

namespace hipmap {

namespace {

std::string hex(std::uint64_t word)
{
    char text[17];
    std::snprintf(text, sizeof text, "%016llx", static_cast<unsigned long long>(word));
    return text;
}

} // namespace

const char* name_of(MapMode mode)
{
    static const char* const kNames[] = {"none", "global", "shared", "thesis", "hierarchical"};
    return kNames[static_cast<int>(mode)];
}

const char* name_of(TreeKind tree)
{
    static const char* const kNames[] = {"wide", "balanced", "unbalanced"};
    return kNames[static_cast<int>(tree)];
}

const char* name_of(Integrator integrator)
{
    static const char* const kNames[] = {"direct", "path", "progressive"};
    return kNames[static_cast<int>(integrator)];
}

const char* name_of(GatheredIrradiance irradiance)
{
    return irradiance == GatheredIrradiance::precomputed ? "precomputed" : "estimated";
}

std::vector<std::string> settings_of(const RenderOptions& options, const Scene& scene,
                                     const Partition& partition, const SkyPicture& sky)
{
    const auto& [integrator, width, height, maps, direct, photons, samples, seed, light,
                 irradiance] = options;
    const auto& [mode, neighbours, local_min, estimate, tiers, directions, tree] = maps;
    const Fingerprint content = content_fingerprint(scene);
    return {"scene=" + hex(content.words[0]) + hex(content.words[1]),
            "sky=" + (sky.empty() ? "plain" : hex(checksum(sky))),
            "partition=" + hex(partition_checksum(partition)),
            "size=" + std::to_string(width) + "x" + std::to_string(height),
            std::string("integrator=") + name_of(integrator),
            std::string("maps=") + name_of(mode),
            std::string("estimate=") + (estimate == EstimateForm::thesis ? "thesis" : "clipped"),
            std::string("tiers=") + (tiers == TierChoice::all ? "all" : "paying"),
            std::string("tree=") + name_of(tree),
            std::string("direct=") + (direct == DirectLight::photons ? "photons" : "shadow-rays"),
            "photons=" + std::to_string(photons),
            "neighbours=" + std::to_string(neighbours),
            "local-min=" + std::to_string(local_min),
            "samples=" + std::to_string(samples),
            "seed=" + std::to_string(seed),
            std::string("caustics=") + (light.caustic ? "on" : "off"),
            std::string("indirect=") + (light.indirect ? "on" : "off"),
            std::string("irradiance=") + name_of(irradiance)};
}

std::uint64_t photons_of(const std::vector<std::string>& settings)
{
    constexpr std::string_view kName = "photons=";
    for (const std::string& setting : settings) {
        std::uint64_t photons = 0;
        if (setting.starts_with(kName) &&
            std::from_chars(setting.data() + kName.size(), setting.data() + setting.size(), photons)
                    .ec == std::errc())
            return photons;
    }
    return 0;
}

} // namespace hipmap
