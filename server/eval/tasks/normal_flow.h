// Optical flow by planes through the times of events.
#pragma once

#include <optional>

#include "base/vec.h"
#include "frame/image.h"

namespace saccade::eval {

inline constexpr int kPlaneRadius = 2;       // of the square of pixels around an event
inline constexpr double kPlaneSpanS = 0.05;  // events further back in time are of another edge
inline constexpr double kPlaneRejectPx =
    1;                                 // an event further from the plane, along x and y, is no part of it
inline constexpr int kPlaneLeast = 9;  // events of a plane

// The velocity across its edge of the latest event, which is at (x, y), pixels per second. Nothing where its
// neighbours lie in no plane. `times`: of its polarity, seconds, -infinity without an event; the border too.
//
// A plane t = t_0 + a x + b y is fitted by least squares. Events far from it are left out, and it is fitted
// again until none is [B14, Algorithm 1]. The edge moves by (a, b) / (a^2 + b^2). The numbers above are ours:
// theirs depend on the units of x and t.
//
// [B14] Benosman et al., Event-Based Visual Flow, TNNLS 2014.
std::optional<Vec2> normalFlow(const Image<double>& times, int x, int y);

}  // namespace saccade::eval
