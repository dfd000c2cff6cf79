#pragma once

namespace hipmap {

inline double square_of(double x)
{
    return x * x;
}

} // namespace hipmap
