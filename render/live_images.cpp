#include "render/live_images.h"

#include "common/image/exposure.h"
#include "common/image/exr_file.h"
#include "common/image/write_image.h"

#include <cmath>

namespace hipmap {

namespace {

/// The share of the time that rewriting images may take.
constexpr double kWritingShare = 0.05;

/// The change of an automatic exposure that is followed, in stops.
constexpr float kVisibleChange = 0.25f;

} // namespace

std::vector<std::filesystem::path> LiveImages::rewrite(const Film& film)
{
    const double begun = watch_.seconds();
    if (files_.images.empty() || writing_ > kWritingShare * (begun - written_))
        return {};
    const Image image = film_image(film);
    const Display display = {exposure_of(image), files_.view};
    for (const std::filesystem::path& path : files_.images)
        if (image_format(path) == ImageFormat::exr)
            write_exr(path, image, {}, film.place);
        else
            write_image(path, image, display);
    written_ = watch_.seconds();
    writing_ = written_ - begun;
    return files_.images;
}

float LiveImages::exposure_of(const Image& image)
{
    if (files_.exposure_ev)
        return *files_.exposure_ev;
    const float now = auto_exposure(image);
    if (!exposure_ev_ || std::abs(now - *exposure_ev_) > kVisibleChange)
        exposure_ev_ = now;
    return *exposure_ev_;
}

} // namespace hipmap
