#include "common/scene/hipmap_extras.h"

#include "common/scene/scene_names.h"

#include <cmath>

namespace hipmap {

using nlohmann::json;

HipmapExtras::HipmapExtras(const json& thing, std::string place, RawScene& scene)
    : place_(std::move(place)), scene_(scene)
{
    const auto extras = thing.find("extras");
    if (extras == thing.end() || !extras->is_object() || !extras->contains("hipmap"))
        return;
    values_ = (*extras)["hipmap"];
    if (values_.is_string()) // parsed without exceptions: a broken text is discarded
        values_ = json::parse(values_.get_ref<const std::string&>(), nullptr, false);
    if (!values_.is_object())
        throw scene_error(scene_.path, place_,
                          "its custom property 'hipmap' is neither an object nor JSON text of one; "
                          "write it as {\"radius\": 0.1}");
}

const json* HipmapExtras::find(const char* key)
{
    known_.insert(key);
    const auto value = values_.find(key);
    used_ = used_ || value != values_.end();
    return value == values_.end() ? nullptr : &*value;
}

std::optional<double> HipmapExtras::positive(const char* key)
{
    const json* const value = find(key);
    if (!value)
        return std::nullopt;
    if (!value->is_number() || !(value->get<double>() >= 0) || !std::isfinite(value->get<double>()))
        fail(key, "must be a number, 0 or more");
    return value->get<double>();
}

std::optional<glm::dvec3> HipmapExtras::positive_triple(const char* key)
{
    const json* const value = find(key);
    if (!value)
        return std::nullopt;
    glm::dvec3 out(0.0);
    bool good = value->is_array() && value->size() == 3;
    for (int c = 0; good && c < 3; ++c) {
        const json& element = (*value)[static_cast<std::size_t>(c)];
        good = element.is_number() && element.get<double>() >= 0 &&
               std::isfinite(element.get<double>());
        if (good)
            out[c] = element.get<double>();
    }
    if (!good)
        fail(key, "must be three numbers, 0 or more");
    return out;
}

std::optional<std::string> HipmapExtras::text(const char* key)
{
    const json* const value = find(key);
    if (!value)
        return std::nullopt;
    if (!value->is_string())
        fail(key, "must be text");
    return value->get<std::string>();
}

std::optional<bool> HipmapExtras::flag(const char* key)
{
    const json* const value = find(key);
    if (!value)
        return std::nullopt;
    if (!value->is_boolean())
        fail(key, "must be true or false");
    return value->get<bool>();
}

std::optional<double> HipmapExtras::within(const char* key, double limit)
{
    const json* const value = find(key);
    if (!value)
        return std::nullopt;
    if (!value->is_number() || !(std::abs(value->get<double>()) <= limit))
        fail(key, "must be a number from " + short_number(-limit) + " to " + short_number(limit));
    return value->get<double>();
}

std::optional<std::vector<double>> HipmapExtras::numbers(const char* key, std::size_t count,
                                                         double limit)
{
    const json* const value = find(key);
    if (!value)
        return std::nullopt;
    std::vector<double> out;
    const bool is_whole = value->is_array() && value->size() == count;
    for (std::size_t i = 0; is_whole && i < count; ++i)
        if ((*value)[i].is_number() && std::abs((*value)[i].get<double>()) <= limit)
            out.push_back((*value)[i].get<double>());
    if (out.size() != count)
        fail(key, "must be " + std::to_string(count) + " numbers from " + short_number(-limit) +
                      " to " + short_number(limit));
    return out;
}

std::optional<HipmapExtras> HipmapExtras::object(const char* key)
{
    const json* const value = find(key);
    if (!value)
        return std::nullopt;
    if (!value->is_object())
        fail(key, "must be an object, such as {\"scattering\": [1, 1, 1]}");
    HipmapExtras out(place_ + ", " + quote_name(key), scene_);
    out.values_ = *value;
    return out;
}

void HipmapExtras::finish(const std::string& effect) const
{
    std::vector<std::string> unknown;
    for (const auto& [key, value] : values_.items())
        if (!known_.contains(key))
            unknown.push_back(clean_name(key));
    if (!unknown.empty())
        scene_.audit.warnings.push_back("custom property 'hipmap' of " + place_ + ": unknown key " +
                                        list_names(unknown) + "; see docs/scene.md");
    if (used_ && !effect.empty())
        scene_.audit.warnings.push_back("read but not rendered yet: " + effect + " of " + place_);
}

void HipmapExtras::fail(const std::string& key, const std::string& what) const
{
    throw scene_error(scene_.path, place_ + ", custom property 'hipmap'",
                      quote_name(key) + " " + what + "; correct it and export again");
}

} // namespace hipmap
