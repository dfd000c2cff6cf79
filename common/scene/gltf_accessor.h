#pragma once

#include <glm/glm.hpp>
#include <tiny_gltf.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hipmap {

/// The bytes of one bufferView as elements.
struct ElementSpan {
    const unsigned char* first = nullptr; ///< null: all zero
    std::size_t stride = 0;
    int component_type = 0; ///< 5120 to 5126

    /// Returns one component of element `i` as a number, not normalised.
    double component(std::size_t i, int c) const;
};

/// Where the elements of a glTF accessor, or of its sparse part, lie in a bufferView.
struct ElementLayout {
    int view = 0;           ///< index of the bufferView
    std::size_t offset = 0; ///< bytes from its start
    int type = 0;           ///< TINYGLTF_TYPE_
    int component_type = 0; ///< 5120 to 5126
    std::size_t count = 0;  ///< elements
};

/// The elements of a glTF accessor, all of them known to lie within their buffer.
class GltfAccessor {
  public:
    /// Checks the accessor.  Throws InputError, naming it, unless type, component type, stride,
    /// count and range are sound, and a sparse part points into it in rising order.
    GltfAccessor(const tinygltf::Model& model, int index, const std::filesystem::path& path);

    std::size_t size() const { return count_; }
    int type() const { return type_; } ///< TINYGLTF_TYPE_
    int component_type() const { return base_.component_type; }
    bool normalized() const { return normalized_; }

    /// Returns element `i` < size() of a VEC2, VEC3 or VEC4, normalised integers as fractions.
    glm::dvec2 vec2(std::size_t i) const;
    glm::dvec3 vec3(std::size_t i) const;
    glm::dvec4 vec4(std::size_t i) const;
    /// Returns element `i` < size() of a MAT4 of floats.
    glm::dmat4 mat4(std::size_t i) const;
    /// Returns element `i` < size() of a SCALAR; `index` reads unsigned integers.
    double scalar(std::size_t i) const { return value(i, 0); }
    std::uint32_t index(std::size_t i) const;

  private:
    void read_sparse(const tinygltf::Model& model, const tinygltf::Accessor& accessor);
    ElementSpan elements(const tinygltf::Model& model, const ElementLayout& layout) const;
    double value(std::size_t i, int c) const;
    [[noreturn]] void fail(const std::string& what) const;

    const std::filesystem::path& path_;
    std::string place_;
    std::size_t count_ = 0;
    int type_ = 0;
    bool normalized_ = false;
    ElementSpan base_;
    std::vector<std::uint32_t> sparse_indices_; ///< rising
    ElementSpan sparse_values_;
};

} // namespace hipmap
