#include "common/image/colour_scale.h"
#include "common/image/srgb.h"
#include "render/film/error_picture.h"
#include "render/film/image_error.h"
#include "tests/render/film/synthetic_passes.h"

#include <catch2/catch.hpp>
#include <glm/geometric.hpp>

using namespace hipmap;

namespace {

Film film_of(const SyntheticPasses& passes, std::uint64_t count)
{
    Film film = make_film(passes.side, passes.side, 1,
                          passes.radii ? BiasKnowledge::from_radii : BiasKnowledge::unbiased);
    for (std::uint64_t pass = 0; pass < count; ++pass)
        add_pass(film, pass, passes.pass(pass));
    return film;
}

double mean_square(const std::vector<double>& errors)
{
    double sum = 0;
    for (const double error : errors)
        sum += error * error;
    return sum / static_cast<double>(errors.size());
}

} // namespace

TEST_CASE("error picture: the mean square of pixels is that of the image", "[film]")
{
    SyntheticPasses passes;
    passes.pixel_noise = passes.photon_noise = 1e-3; // the weights' own noise is of second order
    passes.radii = false;
    const Film film = film_of(passes, 16);
    const std::vector<double> errors = relative_errors(film);
    CHECK(mean_square(errors) == Approx(estimate_error(film)->noise2).epsilon(1e-3));

    passes.radii = true;
    passes.bias = 0.2;
    passes.order = 2;
    const Film biased = film_of(passes, 16);
    const ImageError whole = estimate_error(biased).value();
    CHECK(whole.bias2 > 100 * whole.noise2);
    // The image's bias is weighed by means without bias, its pixels' by their means.
    CHECK(mean_square(relative_errors(biased)) == Approx(whole.error * whole.error).epsilon(0.1));
}

TEST_CASE("error picture: what is black has no error, and what no batch agrees on has much",
          "[film]")
{
    PassImages black{Image(2, 1), {}, {}, {1, 1}};
    Film film = make_film(2, 1, 1, BiasKnowledge::unbiased);
    for (std::uint64_t pass = 0; pass < 8; ++pass)
        add_pass(film, pass, black);
    CHECK(relative_errors(film) == std::vector<double>{0, 0});
    black.radiance.pixels[1] = Rgb(1);
    add_pass(film, 8, black);
    const std::vector<double> errors = relative_errors(film);
    CHECK(errors[0] == 0);
    CHECK(errors[1] > 0.5);
}

TEST_CASE("error picture: the scale goes from 0.1 to 100 % in ratios, and is clipped", "[film]")
{
    const auto colour = [](double t) {
        const Rgb linear = scale_colour(t);
        return Rgb(srgb_from_linear(linear.x), srgb_from_linear(linear.y),
                   srgb_from_linear(linear.z));
    };
    const Image picture = error_picture(7, 1, {0, 1e-3, 0.01, 0.1, 1, 20, 1e300});
    const std::vector<double> expected = {0, 0, 1 / 3.0, 2 / 3.0, 1, 1, 1};
    for (int x = 0; x < 7; ++x)
        CHECK(glm::length(picture.at(x, 0) - colour(expected[static_cast<std::size_t>(x)])) <
              1e-3f);
    REQUIRE(legend_of_errors("error").size() == 1);
    CHECK(legend_of_errors("error")[0].colours.front() == scale_colour(0));
    CHECK(legend_of_errors("error")[0].colours.back() == scale_colour(1));
}
