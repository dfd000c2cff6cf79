#pragma once

#include <cstddef>

namespace hipmap {

/// What one thread of this machine can do at most, measured.
struct MachineLimits {
    double l2 = 0, l3 = 0, dram = 0; ///< bytes read a second, in order, of an array that fits there
    double operations = 0;           ///< float additions and multiplications a second
};

/// Measures by the instruction set in use.  Takes about half a second.
MachineLimits measure_machine();

/// What a search reads.
struct Traffic {
    double nodes = 0;  ///< of 16 boxes
    double blocks = 0; ///< of 16 photons, of which positions are read
    double whole = 0;  ///< blocks of which only powers are
    double bytes = 0;  ///< of all that
    double operations = 0;

    Traffic& operator+=(const Traffic& more);
};

/// Prints how far from each limit a search is that reads so much on average.
void print_roofline(const char* name, const Traffic& mean, double nanoseconds,
                    const MachineLimits& limits);

} // namespace hipmap
