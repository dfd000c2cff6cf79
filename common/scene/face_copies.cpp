#include "common/scene/face_copies.h"

#include <bit>
#include <cmath>

namespace hipmap {

namespace {

/// What turning files' floats into a matrix leaves of a right angle, and less than positions are
/// uncertain by.
constexpr double kRounding = 1e-6;

} // namespace

Similarity compose(const Similarity& second, const Similarity& first)
{
    return {second.turn * first.turn, second.scale * first.scale, second.point(first.move)};
}

Similarity inverse(const Similarity& place)
{
    return {glm::transpose(place.turn), 1 / place.scale, place.point_back(glm::dvec3(0.0))};
}

std::optional<Similarity> to_similarity(const glm::dmat4& transform)
{
    const glm::dmat3 linear(transform);
    const double volume = glm::determinant(linear);
    if (!(volume > 0) || !std::isfinite(volume))
        return {};
    const double scale = std::cbrt(volume);
    const Similarity out{linear / scale, scale, glm::dvec3(transform[3])};
    const glm::dmat3 square = glm::transpose(out.turn) * out.turn;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row)
            if (!(std::abs(square[column][row] - (column == row ? 1 : 0)) <= kRounding))
                return {};
    return out;
}

void drop_unshared(std::vector<SharedFaces>& shared, std::vector<FaceCopy>& copies)
{
    std::vector<std::uint32_t> number(shared.size(), kNone);
    for (const FaceCopy& copy : copies)
        number[copy.shared] = 0;
    std::uint32_t kept = 0;
    for (std::size_t i = 0; i < number.size(); ++i)
        if (number[i] != kNone) {
            shared[kept] = shared[i];
            number[i] = kept++;
        }
    shared.resize(kept);
    for (FaceCopy& copy : copies)
        copy.shared = number[copy.shared];
}

CopyFinder::CopyFinder(std::vector<FaceId> first, FaceId end) : first_(std::move(first)), end_(end)
{
    if (first_.empty())
        return;
    // Blocks of at most as many faces as copies have on average.
    const std::uint32_t faces = end_ - first_.front();
    const auto mean = static_cast<std::uint32_t>(faces / first_.size());
    block_bits_ = mean > 1 ? static_cast<std::uint32_t>(std::bit_width(mean)) - 1 : 0;
    std::uint32_t copy = 0;
    for (std::uint64_t face = first_.front(); face < end_;
         face += std::uint64_t{1} << block_bits_) {
        while (copy + 1 < first_.size() && first_[copy + 1] <= face)
            ++copy;
        copy_at_block_.push_back(copy);
    }
}

CopyFinder find_copies(FaceId stored, std::span<const SharedFaces> shared,
                       std::span<const FaceCopy> copies)
{
    std::vector<FaceId> first;
    first.reserve(copies.size());
    FaceId next = stored;
    for (const FaceCopy& copy : copies) {
        first.push_back(next);
        next += shared[copy.shared].count;
    }
    return {std::move(first), next};
}

} // namespace hipmap
