#pragma once

#include "render/film/error_cost.h"
#include "render/film/fireflies.h"
#include "render/film/render_state.h"
#include "render/integrator/missed_light.h"

#include <span>
#include <string>
#include <vector>

namespace hipmap {

/// A day: errors that take longer are called not practical.
inline constexpr double kMostPracticalSeconds = 24 * 3600;

/// Formats a share as a percentage: "3.2 %" of 0.032.
std::string percent(double share);

/// Describes the estimated error of an image in words.
std::string describe_error(const ErrorCheck& check);

/// Describes the fireflies that were removed ("fireflies: removed from 17 pixels, with 1.2 % of the
/// light"), or else the pixels that carry much of the error and what to do about them.  Empty if
/// neither is known.
std::string describe_fireflies(const ShownFireflies& fireflies);

/// Describes the light that no path has met, and what to do about it.  light: to which it may be
/// due.
std::string describe_unseen(const UnseenLight& unseen, const std::string& light);

/// Describes the light that no path from the eye finds, and what to do about it.  lights: at least
/// one.
std::string describe_unreachable(std::span<const std::string> lights);

/// Describes the light that photons and samples lost.
std::string describe_lost(const LostLight& lost);

/// Describes what an error takes: "would take about 23 passes, 46 s", or "about 23 to 32 passes, 46
/// to 64 s"; beyond a day: "is not practical (more than a day)".
std::string describe_need(const ErrorCost& cost);

/// Describes the cost of halving the error: of the target while it is to be reached, else of the
/// current error.  target: the requested error, 0 for none.  before: s before the first pass.
std::string describe_cost(const RenderState& state, double target, double before);

/// Returns the errors of a cost table: half of the current error, round ones, and the target and
/// half of it.  target: 0 for none.  before: s before the first pass.
std::vector<ErrorCost> error_costs(const RenderState& state, double target, double before);

/// Returns the most memory that this process has held, bytes; 0: unknown.
std::uint64_t peak_memory();

} // namespace hipmap
