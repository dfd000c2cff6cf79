#include "common/setting.h"

#include <charconv>

namespace hipmap {

namespace {

struct TextOf {
    std::string operator()(std::monostate) const { return "none"; }
    std::string operator()(bool on) const { return on ? "on" : "off"; }
    std::string operator()(std::uint64_t number) const { return std::to_string(number); }
    std::string operator()(double number) const
    {
        char text[32];
        return {text, std::to_chars(text, text + sizeof text, number).ptr};
    }
    std::string operator()(const std::string& text) const { return text; }
};

} // namespace

std::string text_of(const SettingValue& value)
{
    return std::visit(TextOf(), value);
}

std::string text_of(const Setting& setting)
{
    return setting.name + "=" + text_of(setting.value);
}

} // namespace hipmap
