#pragma once

#include "common/image/legend.h"
#include "render/film/film.h"

namespace hipmap {

/// Estimates the relative error of each pixel of film_image(film), docs/error.md (13); 1: 100 %.
/// Noisy, and never below zero; 1 for a pixel that less than two batches hold, of a film with
/// parts.  Returns [pixels].
std::vector<double> relative_errors(const Film& film);

/// Returns what relative_errors would if `errors` were the film's own: noise, bias or both, by
/// pixel and channel, never below zero, W/(m2 sr).
std::vector<double> relative_to_image(const Film& film, const Image& errors);

/// Draws errors in false colour, on a logarithmic scale from 0.1 % to 100 %; display values.
Image error_picture(int width, int height, const std::vector<double>& errors);

/// Returns the legend of error_picture.  of: what it shows.
std::vector<LegendEntry> legend_of_errors(const std::string& of);

} // namespace hipmap
