#include "render/live_images.h"

#include "common/image/exposure.h"
#include "render/image_files.h"

#include <cmath>

namespace hipmap {

namespace {

/// The share of the time that rewriting the files of a pace may take.
constexpr double kWritingShare = 0.05;

/// The change of an automatic exposure that is followed, in stops.
constexpr float kVisibleChange = 0.25f;

/// Seconds of a first pass that is worth a coarse image before it.
constexpr double kSlowPass = 1;

} // namespace

bool WritingPace::write(const std::function<void()>& write)
{
    const double begun = watch_.seconds();
    if (writing_ > kWritingShare * (begun - written_))
        return false;
    write();
    written_ = watch_.seconds();
    writing_ = written_ - begun;
    return true;
}

std::vector<std::filesystem::path> LiveImages::rewrite(RenderState& state)
{
    const OutputFiles& files = arguments_.files;
    std::vector<std::filesystem::path> out;
    std::optional<HiddenFireflies> hidden; // found once something is to be written
    const auto hide = [&] {
        if (!hidden)
            hidden.emplace(files.fireflies, state.film);
    };
    if (!files.images.empty() && images_.write([&] {
            hide();
            write_images(film_image(state.film), state);
        }))
        out = files.images;
    const std::vector<RequestedPicture> pictures = known_pictures(files.pictures, state);
    if (!pictures.empty() && pictures_.write([&] {
            hide();
            for (const RequestedPicture& picture : pictures)
                write_picture(picture, state);
        }))
        for (const RequestedPicture& picture : pictures)
            out.push_back(picture.path);
    if (!files.layers.empty() && layers_.write([&] {
            hide();
            write_layers_of(files.layers, arguments_.layers, surfaces_(), film_image(state.film),
                            state);
        }))
        out.push_back(files.layers);
    return out;
}

std::vector<std::filesystem::path> LiveImages::show(const CoarseImage& coarse)
{
    const std::vector<std::filesystem::path>& files = arguments_.files.images;
    const PixelRect pixels = rendered_pixels(arguments_.render);
    if (files.empty() || !(coarse.pass > kSlowPass))
        return {};
    Image image(pixels.width(), pixels.height());
    fill_by_coarse(coarse, std::vector<std::uint8_t>(image.pixels.size()), image);
    RenderState without_passes;
    without_passes.film.place = rendered_place(arguments_.render);
    return images_.write([&] { write_images(image, without_passes); })
               ? files
               : std::vector<std::filesystem::path>();
}

void LiveImages::write_images(const Image& image, const RenderState& state)
{
    const OutputFiles& files = arguments_.files;
    const Display display = {exposure_of(image), files.view};
    for (const std::filesystem::path& path : files.images)
        write_image_of(path, image, state, display);
}

float LiveImages::exposure_of(const Image& image)
{
    if (arguments_.files.exposure_ev)
        return *arguments_.files.exposure_ev;
    const float now = auto_exposure(image);
    if (!exposure_ev_ || std::abs(now - *exposure_ev_) > kVisibleChange)
        exposure_ev_ = now;
    return *exposure_ev_;
}

} // namespace hipmap
