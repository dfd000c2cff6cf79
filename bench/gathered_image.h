#pragma once

#include "render/integrator/eye_path.h"
#include "render/integrator/pass_photons.h"

#include <array>

namespace hipmap {

/// How photons are put into maps.
struct MapSetting {
    DissertationOptions options;
    bool together = false; ///< caustic photons in the maps of the others
};

/// What images of photons share.
struct ImagePlan {
    int width = 256;
    int every = 1; ///< render one band of rows of so many
    std::uint32_t neighbours = 50;
};

/// A scene, the photons of one pass and the eye rays of an image.
struct PhotonStudy {
    static constexpr int kBandRows = 8;

    const RenderScene& scene; ///< borrowed
    MapSurfaces surfaces;
    RenderOptions options;
    int every;
    TracedPhotons traced;
    std::vector<Photon> together;       ///< caustic photons and the others
    std::vector<Rgb> reference;         ///< [pixels] empty: none
    std::vector<Rgb> reference_caustic; ///< [the same] its part by caustic photons

    PhotonStudy(const RenderScene& of, const ImagePlan& plan);

    /// Traces the photons of a pass, as integrator `direct` does.
    void trace(std::uint64_t paths);
    /// Fills `together`.
    void join();
    int bands() const { return (options.height + kBandRows - 1) / kBandRows; }
    /// Returns the share of the pixels that are rendered.
    double share() const;
};

/// An image from photons alone, and what it took.
struct GatheredImage {
    ChosenMaps caustic, global;
    KindStatistics caustic_kind, global_kind;
    EyeScratch scratch;
    double build_s = 0, image_s = 0; ///< of the processor
    std::vector<Rgb> pixels;
};

/// Builds the maps of a study's photons; all pixels are black.
GatheredImage build_maps(const PhotonStudy& study, const MapSetting& setting);

/// Returns an image without photons: what the eye rays alone cost.
GatheredImage without_photons(const PhotonStudy& study);

/// Renders a band of rows, from 0 to bands() - 1, one sample a pixel, and adds what it took.
void render_band(const PhotonStudy& study, int band, GatheredImage& image);

/// Sets the reference: whole images of so many light paths, by shared maps, the default estimate
/// and more neighbours, so that their noise is a third.
void make_reference(PhotonStudy& study, std::uint64_t paths);

/// Returns the root of the mean square difference to the reference over the reference's mean: of
/// the rendered pixels, and of those that get a tenth of their light or more from caustic photons.
std::array<double, 2> relative_errors(const PhotonStudy& study, const GatheredImage& image);

} // namespace hipmap
