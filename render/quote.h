#pragma once

#include "render/frame_source.h"
#include "render/previous_frame.h"

#include <atomic>

namespace hipmap {

/// The share of the predicted time to an error that its quote may take.
inline constexpr double kQuoteShare = 0.05;

/// A frame of which some passes are rendered; all borrowed.
struct QuotedFrame {
    const FramePasses& passes;
    const RenderScene& scene;
    const RenderedFrame& rendered;
};

/// Compares other integrators, and leaving out each effect that is on, with the frame as it is:
/// renders images of up to a quarter of its sides, with at least as many photons a pixel, as long
/// as all that was rendered takes less than kQuoteShare of the predicted time to the error that the
/// options quote; what there is no time for is listed.  stop: true: returns soon, with what is
/// compared so far.
Quote make_quote(const QuotedFrame& frame, const std::atomic<bool>& stop);

} // namespace hipmap
