#include "render/film/state_settings.h"

#include <algorithm>
#include <cmath>

namespace hipmap {

namespace {

constexpr std::uint64_t kMostSettings = 1000;
constexpr std::uint64_t kLongestText = 1 << 20;

/// Kinds of values, by their number in the file.
enum class Kind : std::uint32_t { none, flag, whole, real, text };
static_assert(std::variant_size_v<SettingValue> == 5, "each alternative has a Kind");

struct PutValue {
    StateWriter& out;

    void operator()(std::monostate) const {}
    void operator()(bool on) const { out.put(static_cast<std::uint8_t>(on)); }
    void operator()(std::uint64_t number) const { out.put(number); }
    void operator()(double number) const { out.put(number); }
    void operator()(const std::string& text) const { put_text(out, text); }
};

SettingValue get_value(StateReader& in)
{
    const auto kind = in.get<std::uint32_t>();
    in.require(kind <= static_cast<std::uint32_t>(Kind::text), "kind of setting");
    switch (static_cast<Kind>(kind)) {
    case Kind::flag: {
        const auto on = in.get<std::uint8_t>();
        in.require(on <= 1, "setting");
        return on == 1;
    }
    case Kind::whole:
        return in.get<std::uint64_t>();
    case Kind::real: {
        const auto number = in.get<double>();
        in.require(std::isfinite(number), "setting");
        return number;
    }
    case Kind::text:
        return get_text(in);
    case Kind::none:
        break;
    }
    return {};
}

} // namespace

void put_text(StateWriter& out, const std::string& text)
{
    out.put_array(std::vector<char>(text.begin(), text.end()));
}

std::string get_text(StateReader& in)
{
    const std::vector<char> text = in.get_array<char>(kLongestText);
    in.require(std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~'; }), "text");
    return {text.begin(), text.end()};
}

void put_settings(StateWriter& out, const std::vector<Setting>& settings)
{
    out.put(static_cast<std::uint64_t>(settings.size()));
    for (const Setting& setting : settings) {
        PutValue{out}(setting.name);
        out.put(static_cast<std::uint32_t>(setting.value.index()));
        std::visit(PutValue{out}, setting.value);
    }
}

std::vector<Setting> get_settings(StateReader& in)
{
    const auto size = in.get<std::uint64_t>();
    in.require(size <= kMostSettings, "number of settings");
    std::vector<Setting> settings;
    for (std::uint64_t i = 0; i < size; ++i) {
        std::string name = get_text(in);
        settings.push_back({std::move(name), get_value(in)});
    }
    return settings;
}

} // namespace hipmap
