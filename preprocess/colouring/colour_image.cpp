#include "preprocess/colouring/colour_image.h"

#include "common/image/srgb.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace hipmap {

namespace {

constexpr int kSamplesAcross = 4;
constexpr Rgb kBackground(0.08f);

/// Light that falls on a face seen head-on and edge-on.
constexpr float kHeadOn = 1.0f;
constexpr float kEdgeOn = 0.35f;

float headlight(const TriangleMesh& mesh, FaceId face, const glm::vec3& direction)
{
    const glm::dvec3 normal = scaled_normal(mesh, face);
    const double length = glm::length(normal);
    const double cosine =
        length > 0 ? std::abs(glm::dot(normal, glm::dvec3(direction))) / length : 0.0;
    return kEdgeOn + (kHeadOn - kEdgeOn) * static_cast<float>(std::min(cosine, 1.0));
}

class Pictures {
  public:
    Pictures(const PictureView& view, const std::vector<Painter>& painters)
        : view_(view), painters_(painters), images_(painters.size(), Image(view.width, view.height))
    {
    }

    void paint_pixel(int x, int y)
    {
        const glm::vec2 corner(x, y);
        const Ray left = ray_at(corner);
        const Ray right = ray_at(corner + glm::vec2(1, 0));
        for (int sample = 0; sample < kSamplesAcross * kSamplesAcross; ++sample) {
            const glm::vec2 cell(sample % kSamplesAcross, sample / kSamplesAcross);
            const Ray ray = ray_at(corner + (cell + 0.5f) / float(kSamplesAcross));
            const std::optional<RayHit> hit = view_.rays.nearest(ray);
            if (!hit) {
                for (Image& image : images_)
                    image.at(x, y) += kBackground;
                continue;
            }
            const float t = hit->distance;
            const float pixel =
                glm::length(right.origin + right.direction * t - left.origin - left.direction * t);
            const SeenPoint point{hit->face, ray.origin + ray.direction * t, ray.direction, pixel};
            const float light = headlight(view_.mesh, hit->face, ray.direction);
            for (std::size_t i = 0; i < painters_.size(); ++i)
                images_[i].at(x, y) += painters_[i](point) * light;
        }
        for (Image& image : images_)
            encode(image.at(x, y));
    }

    std::vector<Image> take() { return std::move(images_); }

  private:
    Ray ray_at(const glm::vec2& pixel) const
    {
        const glm::vec2 size(view_.width, view_.height);
        return camera_ray(view_.camera, pixel / size, size.x / size.y);
    }

    static void encode(Rgb& sum)
    {
        for (int channel = 0; channel < 3; ++channel)
            sum[channel] = srgb_from_linear(
                std::clamp(sum[channel] / (kSamplesAcross * kSamplesAcross), 0.0f, 1.0f));
    }

    const PictureView& view_;
    const std::vector<Painter>& painters_;
    std::vector<Image> images_;
};

} // namespace

std::vector<Image> colour_images(const PictureView& view, const std::vector<Painter>& painters)
{
    Pictures pictures(view, painters);
    tbb::parallel_for(0, view.height, [&](int y) {
        for (int x = 0; x < view.width; ++x)
            pictures.paint_pixel(x, y);
    });
    return pictures.take();
}

} // namespace hipmap
