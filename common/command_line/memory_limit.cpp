#include "common/command_line/memory_limit.h"

#include <sys/resource.h>

#include <algorithm>
#include <charconv>
#include <fstream>
#include <sstream>
#include <string>

namespace hipmap {

namespace {

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kMayLimit = false; // they map the whole address space
#elif defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool kMayLimit = false;
#else
constexpr bool kMayLimit = true;
#endif
#else
constexpr bool kMayLimit = true;
#endif

std::string content_of(const char* path)
{
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
}

std::optional<std::uint64_t> number_at(std::string_view text)
{
    text.remove_prefix(std::min(text.size(), text.find_first_not_of(' ')));
    std::uint64_t number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    return error == std::errc() ? std::optional(number) : std::nullopt;
}

/// The bytes that a line "name:  N kB" says.
std::optional<std::uint64_t> bytes_of(std::string_view meminfo, std::string_view name)
{
    const std::size_t at = meminfo.find(name);
    if (at == std::string_view::npos)
        return std::nullopt;
    const std::optional<std::uint64_t> kib = number_at(meminfo.substr(at + name.size()));
    return kib ? std::optional(*kib * 1024) : std::nullopt;
}

} // namespace

std::optional<std::uint64_t> memory_for_a_program(std::string_view meminfo)
{
    const auto total = bytes_of(meminfo, "MemTotal:");
    const auto available = bytes_of(meminfo, "MemAvailable:");
    if (!total || !available)
        return std::nullopt;
    return std::max(*available, *total / 2) + bytes_of(meminfo, "SwapFree:").value_or(0);
}

void limit_memory()
{
    if (!kMayLimit)
        return;
    std::optional<std::uint64_t> most = memory_for_a_program(content_of("/proc/meminfo"));
    rlimit limit = {};
    if (!most || ::getrlimit(RLIMIT_DATA, &limit) != 0)
        return;
    // Where the program sees the group as the root of its control groups, as in containers.
    for (const char* group :
         {"/sys/fs/cgroup/memory.max", "/sys/fs/cgroup/memory/memory.limit_in_bytes"})
        if (const auto of_group = number_at(content_of(group)); of_group && *of_group > 0)
            most = std::min(*most, *of_group);
    if (limit.rlim_cur <= *most)
        return;
    limit.rlim_cur = *most;
    ::setrlimit(RLIMIT_DATA, &limit); // without it the kernel decides
}

} // namespace hipmap
