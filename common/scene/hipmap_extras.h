#pragma once

#include "common/scene/raw_scene.h"

#include <nlohmann/json.hpp>

#include <initializer_list>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace hipmap {

/// The values under `extras.hipmap` of one thing in a glTF file: an object, or an object as JSON
/// text, which a custom property in Blender can hold.
class HipmapExtras {
  public:
    /// Reads the extras of one thing.  thing: the JSON that may have extras.  place: its name in
    /// errors, such as "light 'Lamp'".  Throws InputError if the extras are neither an object nor
    /// the text of one.
    HipmapExtras(const nlohmann::json& thing, std::string place, RawScene& scene);

    /// Returns the value of a key and marks the key as known; nothing if it is absent.  Throws
    /// InputError, naming the key, if the value is of another type, negative or not finite.
    std::optional<double> positive(const char* key);
    std::optional<glm::dvec3> positive_triple(const char* key);
    std::optional<std::string> text(const char* key);

    std::optional<bool> flag(const char* key);

    /// Returns the value of a key, a number from -limit to limit.
    std::optional<double> within(const char* key, double limit);

    /// Returns the value of a key, an array of `count` numbers from -limit to limit.
    std::optional<std::vector<double>> numbers(const char* key, std::size_t count, double limit);

    /// Returns an object within the object, with its own keys; the caller must call its `finish`.
    std::optional<HipmapExtras> object(const char* key);

    /// Warns of the keys that were not asked for, and says that `effect` is not rendered yet if any
    /// other was there.
    void finish(const std::string& effect) const;

    [[noreturn]] void fail(const std::string& key, const std::string& what) const;

  private:
    HipmapExtras(std::string place, RawScene& scene) : place_(std::move(place)), scene_(scene) {}

    const nlohmann::json* find(const char* key);

    nlohmann::json values_ = nlohmann::json::object();
    std::string place_;
    RawScene& scene_;
    std::set<std::string> known_;
    bool used_ = false;
};

} // namespace hipmap
