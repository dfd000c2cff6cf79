#include "common/scene/gltf_document.h"
#include "common/scene/gltf_rules.h"
#include "common/scene/raw_scene.h"

#include <cstdint>
#include <string_view>

namespace hipmap {

namespace {

using nlohmann::json;
using std::string_view;

/// The first part of a path, which is cut off it.
string_view take_step(string_view& path)
{
    const std::size_t slash = path.find('/');
    const string_view step = path.substr(0, slash);
    path = slash == string_view::npos ? string_view() : path.substr(slash + 1);
    return step;
}

std::size_t array_size(const json& root, string_view path)
{
    const json* at = &root;
    while (!path.empty()) {
        const string_view step = take_step(path);
        if (!at->is_object() || !at->contains(step))
            return 0;
        at = &(*at)[std::string(step)];
    }
    return at->size();
}

/// Whether `name` begins and ends as the pattern "begin*end" says; "{}": any name.
bool is_match(string_view name, string_view pattern)
{
    if (pattern == "{}")
        return true;
    const std::size_t star = pattern.find('*');
    return name.size() >= pattern.size() - 1 && name.starts_with(pattern.substr(0, star)) &&
           name.ends_with(pattern.substr(star + 1));
}

class SchemaCheck {
  public:
    explicit SchemaCheck(const GltfDocument& document) : document_(document) {}

    void apply(const GltfRule& rule)
    {
        if (rule.want == GltfWant::index)
            index_limit_ = array_size(document_.json, rule.target);
        walk(rule, document_.json, rule.path, "");
    }

  private:
    void walk(const GltfRule& rule, const json& value, string_view path, const std::string& place)
    {
        if (path.empty())
            return check(rule, value, place);
        const string_view step = take_step(path);
        if (step == "[]") {
            for (std::size_t i = 0; i < value.size(); ++i)
                walk(rule, value[i], path, place + "[" + std::to_string(i) + "]");
        } else if (step == "{}" || step.find('*') != string_view::npos) {
            for (const auto& [key, member] : value.items())
                if (is_match(key, step))
                    walk(rule, member, path, place + "." + key);
        } else {
            const auto member = value.find(step);
            const std::string next = (place.empty() ? "" : place + ".") + std::string(step);
            if (member != value.end())
                walk(rule, *member, path, next);
            else if (rule.required && path.empty())
                fail(next, "missing");
        }
    }

    void check(const GltfRule& rule, const json& value, const std::string& place) const
    {
        const auto demand = [&](bool good, const std::string& what) {
            if (!good)
                fail(place, "must be " + what);
        };
        switch (rule.want) {
        case GltfWant::object:
            return demand(value.is_object(), "an object");
        case GltfWant::array:
            return demand(value.is_array(), "an array");
        case GltfWant::filled_array:
            return demand(value.is_array() && !value.empty(), "an array that is not empty");
        case GltfWant::string:
            return demand(value.is_string(), "text");
        case GltfWant::boolean:
            return demand(value.is_boolean(), "true or false");
        case GltfWant::number:
            return demand(value.is_number(), "a number");
        case GltfWant::numbers:
            return demand(is_numbers(value, rule.size), std::to_string(rule.size) + " numbers");
        case GltfWant::offset:
            return demand(is_integer_in(value, 0, kLargest), "an integer, 0 or more");
        case GltfWant::count:
            return demand(is_integer_in(value, 1, kLargest), "an integer, 1 or more, below 2^53");
        case GltfWant::integer_to:
            return demand(is_integer_in(value, 0, static_cast<std::uint64_t>(rule.size)),
                          "an integer from 0 to " + std::to_string(rule.size));
        case GltfWant::index:
            if (!is_integer_in(value, 0, kLargest))
                fail(place, "must be an index");
            if (value.get<std::uint64_t>() >= index_limit_)
                fail(place, "is " + value.dump() + ", but '" + rule.target + "' has only " +
                                std::to_string(index_limit_) + " entries, counted from 0");
            return;
        }
    }

    static bool is_integer_in(const json& value, std::uint64_t low, std::uint64_t high)
    {
        return value.is_number_unsigned() && value.get<std::uint64_t>() >= low &&
               value.get<std::uint64_t>() <= high;
    }

    static bool is_numbers(const json& value, int size)
    {
        if (!value.is_array() || value.size() != static_cast<std::size_t>(size))
            return false;
        for (const json& element : value)
            if (!element.is_number())
                return false;
        return true;
    }

    [[noreturn]] void fail(const std::string& place, const std::string& what) const
    {
        throw scene_error(document_.path, place, what + "; the file is damaged, export it again");
    }

    static constexpr std::uint64_t kLargest = std::uint64_t{1} << 53;

    const GltfDocument& document_;
    std::size_t index_limit_ = 0;
};

/// Every bufferView lies within the length its buffer declares.
void check_buffer_views(const GltfDocument& document)
{
    const json& root = document.json;
    for (std::size_t i = 0; i < array_size(root, "bufferViews"); ++i) {
        const json& view = root["bufferViews"][i];
        const auto offset = view.value("byteOffset", std::uint64_t{0});
        const auto length = view["byteLength"].get<std::uint64_t>();
        const json& buffer = root["buffers"][view["buffer"].get<std::size_t>()];
        const auto room = buffer["byteLength"].get<std::uint64_t>();
        if (offset > room || length > room - offset)
            throw scene_error(document.path, "bufferViews[" + std::to_string(i) + "]",
                              "runs past the end of its buffer; the file is damaged, export it "
                              "again");
    }
}

} // namespace

void check_gltf_schema(const GltfDocument& document)
{
    SchemaCheck check(document);
    for (const GltfRule& rule : kGltfRules)
        check.apply(rule);
    check_buffer_views(document);
}

} // namespace hipmap
