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

/// The shortest text that is read back as the same number.
std::string exactly(double value)
{
    char text[32];
    return {text, std::to_chars(text, text + sizeof text, value).ptr};
}

/// name: with its sign of equality.
template <typename Number>
Number number_of(const std::vector<std::string>& settings, std::string_view name, Number otherwise)
{
    for (const std::string& setting : settings) {
        Number number{};
        if (setting.starts_with(name) &&
            std::from_chars(setting.data() + name.size(), setting.data() + setting.size(), number)
                    .ec == std::errc())
            return number;
    }
    return otherwise;
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

const char* name_of(PixelFilter filter)
{
    return filter == PixelFilter::box ? "box" : "b-spline";
}

std::vector<std::string> settings_of(const RenderOptions& options, const Scene& scene,
                                     const Partition& partition, const SkyPicture& sky)
{
    const auto& [integrator, width, height, maps, direct, photons, samples, seed, light, irradiance,
                 alpha, filter] = options;
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
            std::string("irradiance=") + name_of(irradiance),
            "alpha=" + exactly(alpha),
            std::string("filter=") + name_of(filter)};
}

std::uint64_t photons_of(const std::vector<std::string>& settings)
{
    return number_of(settings, "photons=", std::uint64_t{0});
}

double alpha_of(const std::vector<std::string>& settings)
{
    return number_of(settings, "alpha=", RenderOptions().alpha);
}

} // namespace hipmap
