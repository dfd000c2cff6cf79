#include "common/scene/obj_text.h"

#include "common/file/output_file.h"
#include "common/scene/raw_scene.h"
#include "common/scene/scene_names.h"

#include <array>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string_view>

namespace hipmap {

namespace {

using std::string_view;

string_view take_word(string_view& rest)
{
    const std::size_t begin = rest.find_first_not_of(" \t");
    if (begin == string_view::npos)
        return rest = {};
    const std::size_t end = std::min(rest.find_first_of(" \t", begin), rest.size());
    const string_view word = rest.substr(begin, end - begin);
    rest.remove_prefix(end);
    return word;
}

/// Turns every line end into "\n": tinyobjloader ends lines at any "\r", and what is checked must
/// be what it reads.
void unify_line_ends(std::string& text)
{
    std::size_t kept = 0;
    for (std::size_t i = 0; i < text.size(); ++i)
        if (text[i] != '\r')
            text[kept++] = text[i];
        else if (i + 1 == text.size() || text[i + 1] != '\n')
            text[kept++] = '\n';
    text.resize(kept);
}

/// Replaces "\" before a line end by a space and moves the line end behind the joined line, so
/// that lines keep their numbers.
void join_continued_lines(std::string& text)
{
    if (text.find('\\') == std::string::npos)
        return;
    std::string joined;
    joined.reserve(text.size());
    std::size_t owed = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (text[i] == '\\' && i + 1 < text.size() && text[i + 1] == '\n') {
            joined += ' ';
            ++owed;
            ++i;
        } else {
            joined += text[i];
            if (text[i] == '\n') {
                joined.append(owed, '\n');
                owed = 0;
            }
        }
    }
    text = std::move(joined);
}

bool is_finite_number(string_view word)
{
    if (word.starts_with('+'))
        word.remove_prefix(1);
    double value = 0.0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (end != word.data() + word.size())
        return false;
    if (error == std::errc::result_out_of_range) // too small is zero, too large is not a number
        value = std::strtod(std::string(word).c_str(), nullptr);
    else if (error != std::errc())
        return false;
    return std::isfinite(value);
}

/// Walks the lines of an OBJ file once.
class ObjCheck {
  public:
    ObjCheck(const std::filesystem::path& path, ObjText& out) : path_(path), out_(out) {}

    void run()
    {
        string_view rest = out_.text;
        while (!rest.empty()) {
            ++line_;
            const std::size_t end = std::min(rest.find('\n'), rest.size());
            check_line(rest.substr(0, end));
            rest.remove_prefix(std::min(end + 1, rest.size()));
        }
    }

  private:
    static constexpr std::array<const char*, 3> kKinds = {"vertex", "texture vertex", "normal"};

    void check_line(string_view line)
    {
        if (line.find('\0') != string_view::npos)
            fail("contains a NUL byte");
        const string_view key = take_word(line);
        if (key == "v") {
            const std::size_t numbers = check_numbers(line, 3);
            out_.has_colours = out_.has_colours || numbers >= 6;
            ++count_[0];
        } else if (key == "vt") {
            check_numbers(line, 1);
            ++count_[1];
        } else if (key == "vn") {
            check_numbers(line, 3);
            ++count_[2];
        } else if (key == "f") {
            check_face(line);
        } else if (key == "mtllib") {
            const std::size_t begin = line.find_first_not_of(" \t");
            const std::size_t end = line.find_last_not_of(" \t");
            if (begin != string_view::npos)
                out_.material_libs.emplace_back(line.substr(begin, end - begin + 1));
        } else if (key == "o") {
            out_.has_objects = true;
        } else if (key == "l" || key == "p") {
            out_.has_lines_or_points = true;
        } else if (key == "curv" || key == "surf") {
            out_.has_curves = true;
        }
    }

    std::size_t check_numbers(string_view line, std::size_t at_least) const
    {
        std::size_t numbers = 0;
        for (string_view word = take_word(line); !word.empty(); word = take_word(line)) {
            if (word.starts_with('#'))
                break;
            if (!is_finite_number(word))
                fail(quote_name(word) + " is not a finite number");
            ++numbers;
        }
        if (numbers < at_least)
            fail("has fewer than " + std::to_string(at_least) + " numbers");
        return numbers;
    }

    void check_face(string_view line)
    {
        std::size_t corners = 0;
        for (string_view word = take_word(line); !word.empty(); word = take_word(line)) {
            if (word.starts_with('#'))
                fail("has a comment after its corners, which is not supported; move it");
            check_corner(word);
            ++corners;
        }
        if (corners < 3)
            ++out_.short_faces;
    }

    /// Checks a corner of a face: "v", "v/vt", "v//vn" or "v/vt/vn".
    void check_corner(string_view word)
    {
        const string_view whole = word;
        for (std::size_t kind = 0; kind < 3; ++kind) {
            const std::size_t slash = word.find('/');
            const string_view index = word.substr(0, slash);
            if (!index.empty())
                check_index(kind, index, whole);
            else if (kind != 1)
                fail(quote_name(whole) + " is not a corner of a face");
            if (slash == string_view::npos)
                return;
            word.remove_prefix(slash + 1);
        }
        fail(quote_name(whole) + " is not a corner of a face");
    }

    void check_index(std::size_t kind, string_view text, string_view whole)
    {
        std::int64_t index = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
        constexpr std::int64_t kMost = std::numeric_limits<std::int32_t>::max();
        if (error != std::errc() || end != text.data() + text.size() || index == 0 ||
            index > kMost || index < -kMost)
            fail(quote_name(whole) + " is not a corner of a face");
        const auto distance = static_cast<std::uint64_t>(index < 0 ? -index : index);
        if (distance > count_[kind])
            fail(quote_name(whole) + " names a " + kKinds[kind] + " that does not exist (" +
                 std::to_string(count_[kind]) + " come before it)");
    }

    [[noreturn]] void fail(const std::string& what) const
    {
        throw scene_error(path_, "line " + std::to_string(line_),
                          what + "; correct the line or export the file again");
    }

    const std::filesystem::path& path_;
    ObjText& out_;
    std::size_t line_ = 0;
    std::array<std::uint64_t, 3> count_{}; ///< v, vt, vn so far
};

} // namespace

ObjText read_obj_text(const std::filesystem::path& path)
{
    const std::vector<std::byte> bytes = read_file(path);
    ObjText out;
    out.text.assign(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    unify_line_ends(out.text);
    join_continued_lines(out.text);
    ObjCheck(path, out).run();
    return out;
}

} // namespace hipmap
