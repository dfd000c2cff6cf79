#pragma once

#include "bench/even_room.h"
#include "tests/support/statistics.h"

namespace hipmap::tiny {

/// Means of the estimates at each point and where a quarter turn of the room brings it.
inline std::vector<RunningMean> means_in_even_room(const std::vector<glm::vec2>& points,
                                                   const EvenRoomOptions& options)
{
    constexpr std::size_t kTurns = 4;
    std::vector<glm::vec2> turned;
    for (glm::vec2 at : points)
        for (std::size_t turn = 0; turn < kTurns; ++turn, at = {1 - at.y, at.x})
            turned.push_back(at);
    const std::vector<std::vector<double>> estimates = estimates_in_even_room(turned, options);
    std::vector<RunningMean> means(points.size());
    for (std::size_t i = 0; i < points.size(); ++i)
        for (std::size_t set = 0; set < options.sets; ++set) {
            double sum = 0;
            for (std::size_t turn = 0; turn < kTurns; ++turn)
                sum += estimates[kTurns * i + turn][set];
            means[i].add(sum / kTurns);
        }
    return means;
}

} // namespace hipmap::tiny
