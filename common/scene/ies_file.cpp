#include "common/scene/ies_file.h"

#include "common/file/output_file.h"
#include "common/input_error.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <numbers>
#include <string>
#include <string_view>

namespace hipmap {

namespace {

constexpr double kRadians = std::numbers::pi / 180;
constexpr double kLeastStep = 1e-6; ///< degrees, between angles of a table
constexpr double kTypeC = 1; ///< of photometry: polar angles from the axis, azimuths about it

bool is_space(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\n' || c == ',';
}

/// The text of an LM-63 file, read from the start.
class IesText {
  public:
    IesText(const std::filesystem::path& path, std::string_view text) : path_(path), rest_(text) {}

    /// Skips to the text after "TILT=" at the start of a line, and returns that line's rest.
    std::string_view find_tilt()
    {
        constexpr std::string_view kTilt = "TILT=";
        while (!rest_.empty()) {
            const std::string_view line = take_line();
            const std::size_t start = line.find_first_not_of(" \t");
            if (start != std::string_view::npos && line.substr(start).starts_with(kTilt))
                return line.substr(start + kTilt.size());
        }
        throw InputError(path_.string() +
                         ": no line TILT=, so not IES LM-63; use a .ies file of the maker");
    }

    /// Returns the next number.  what: its name in errors.
    double next(const char* what)
    {
        while (!rest_.empty() && is_space(rest_.front()))
            drop();
        if (!rest_.empty() && rest_.front() == '+')
            drop();
        double out = 0;
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), out);
        if (error != std::errc() || !std::isfinite(out))
            fail(std::string("no number where ") + what + " belongs; download the file again");
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        return out;
    }

    /// Returns the next number, which counts what follows.  least: the smallest that makes sense.
    std::size_t next_count(const char* what, double least)
    {
        const double out = next(what);
        // Each number counted takes two characters.
        if (!(out >= least) || out != std::floor(out) ||
            !(out <= static_cast<double>(rest_.size())))
            fail(std::string("the number of ") + what + " makes no sense; download the file again");
        return static_cast<std::size_t>(out);
    }

    [[noreturn]] void fail(const std::string& what) const
    {
        throw InputError(path_.string() + ": line " + std::to_string(line_) + ": " + what);
    }

  private:
    void drop()
    {
        line_ += rest_.front() == '\n' ? 1 : 0;
        rest_.remove_prefix(1);
    }
    std::string_view take_line()
    {
        const std::size_t end = std::min(rest_.find('\n'), rest_.size());
        std::string_view line = rest_.substr(0, end);
        rest_.remove_prefix(std::min(end + 1, rest_.size()));
        ++line_;
        while (!line.empty() && is_space(line.back()))
            line.remove_suffix(1);
        return line;
    }

    const std::filesystem::path& path_;
    std::string_view rest_;
    std::size_t line_ = 1;
};

/// What stands between TILT and the angles.
struct IesHeader {
    double factor = 1; ///< of all intensities
    std::size_t polar = 0, azimuths = 0;
};

/// Skips how the output changes when the luminaire is tilted; the intensities are those measured.
void skip_tilt(IesText& text)
{
    const std::string_view tilt = text.find_tilt();
    if (tilt == "NONE")
        return;
    if (tilt != "INCLUDE")
        text.fail("TILT names another file; only TILT=NONE and TILT=INCLUDE are read");
    text.next("the lamp's geometry");
    for (std::size_t i = 2 * text.next_count("tilt angles", 0); i > 0; --i)
        text.next("a tilt angle or factor");
}

IesHeader read_header(IesText& text)
{
    IesHeader out;
    text.next("the number of lamps");
    text.next("the lumens of a lamp");
    out.factor = text.next("the multiplier");
    out.polar = text.next_count("vertical angles", 2);
    out.azimuths = text.next_count("horizontal angles", 1);
    if (text.next("the photometric type") != kTypeC)
        text.fail("photometry of type A or B; ask the maker for a file of type C");
    for (const char* what : {"the unit of length", "the width", "the length", "the height"})
        text.next(what);
    out.factor *= text.next("the ballast factor");
    out.factor *= text.next("the ballast-lamp factor");
    text.next("the input watts");
    if (!(out.factor > 0) || !std::isfinite(out.factor))
        text.fail("the multiplier and ballast factors must be above 0; correct them");
    return out;
}

/// Returns angles in degrees, which rise.
std::vector<double> read_angles(IesText& text, std::size_t count, double most, const char* what)
{
    std::vector<double> out;
    for (std::size_t i = 0; i < count; ++i) {
        const double angle = text.next(what);
        if (!(angle >= 0 && angle <= most) || (i > 0 && !(angle - out.back() > kLeastStep)))
            text.fail(std::string(what) + " is out of range or below the one before it; download "
                                          "the file again");
        out.push_back(angle);
    }
    return out;
}

/// A half-plane about the axis.
struct IesPlane {
    double azimuth;       ///< degrees
    std::size_t measured; ///< place among those of the file
};

/// Adds the mirror images of all planes but the last, which is the mirror.
void mirror(std::vector<IesPlane>& planes)
{
    const double at = planes.back().azimuth;
    for (std::size_t i = planes.size() - 1; i-- > 0;)
        planes.push_back({2 * at - planes[i].azimuth, planes[i].measured});
}

/// Returns planes from 0 to 360 degrees.  The last azimuth of the file says which symmetry it has.
std::vector<IesPlane> all_around(const std::vector<double>& azimuths, const IesText& text)
{
    std::vector<IesPlane> out;
    for (std::size_t i = 0; i < azimuths.size(); ++i)
        out.push_back({azimuths[i], i});
    const double last = azimuths.back();
    if (azimuths.front() != 0 || (last > 0 && last < 180 && last != 90))
        text.fail("horizontal angles must go from 0 to 0, 90, 180 or 360; write the file with "
                  "those from 0 to 360");
    if (last == 90)
        mirror(out);
    if (last == 90 || last == 180)
        mirror(out);
    if (out.back().azimuth < 360 - kLeastStep)
        out.push_back({360, 0});
    out.back().azimuth = 360;
    return out;
}

/// Returns [azimuths * polar] intensities, candela.
std::vector<double> read_intensities(IesText& text, const IesHeader& header)
{
    std::vector<double> out;
    for (std::size_t i = 0; i < header.azimuths * header.polar; ++i) {
        out.push_back(header.factor * text.next("an intensity"));
        if (!(out.back() >= 0) || !std::isfinite(static_cast<float>(out.back())))
            text.fail("an intensity is negative or too large; correct it");
    }
    if (*std::max_element(out.begin(), out.end()) == 0)
        text.fail("all intensities are 0; use another file");
    return out;
}

} // namespace

PhotometricWeb read_ies(const std::filesystem::path& path)
{
    const std::vector<std::byte> bytes = read_file(path);
    IesText text(path, {reinterpret_cast<const char*>(bytes.data()), bytes.size()});
    skip_tilt(text);
    const IesHeader header = read_header(text);
    const std::vector<double> polar = read_angles(text, header.polar, 180, "a vertical angle");
    const std::vector<double> azimuths =
        read_angles(text, header.azimuths, 360, "a horizontal angle");
    const std::vector<IesPlane> planes = all_around(azimuths, text);
    const std::vector<double> intensities = read_intensities(text, header);
    PhotometricWeb out;
    for (std::size_t i = 0; i < polar.size(); ++i) {
        out.polar.push_back(polar[i] * kRadians);
        for (const IesPlane& plane : planes)
            out.candela.push_back(intensities[plane.measured * polar.size() + i]);
    }
    for (const IesPlane& plane : planes)
        out.azimuth.push_back(plane.azimuth * kRadians);
    return out;
}

} // namespace hipmap
