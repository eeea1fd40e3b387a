// When events happen between two frames. The phase of an event is (t - t0) / (t1 - t0), in [0, 1), between
// the times of the frames around it.
//
// Under steady motion phases are even. A sensor sees only frames. Where noise turns brightness back, its
// pixels wait longer for the next threshold, and fewer events lie early in the interval.
#pragma once

#include <cstdint>
#include <vector>

#include "saccade/wire/event.h"

namespace saccade::eval {

struct FrameInterval {
  std::int64_t t0_ns, t1_ns;  // t0_ns < t1_ns
};
using FrameIntervals = std::vector<FrameInterval>;  // in order, apart from each other or adjacent

struct PhasedEvent {
  std::uint32_t pixel;
  int bin;  // of the phase, 0 to kPhaseBins - 1
};
using PhasedEvents = std::vector<PhasedEvent>;
inline constexpr int kPhaseBins = 10;

// Events outside the intervals are left out.
PhasedEvents phasesOf(const Events& events, const FrameIntervals& intervals);

// The share of the events in another tenth of the interval than in ref. D = 1/2 sum |p - q| over the bins,
// with the shares p of x and q of ref. From 0 to 1. Both streams are of the same pixels; NaN if one is empty.
//
// Counts that are random make D > 0 for equal distributions. In the mean E = 1/2 sum sqrt(2 V / pi), for
// normal p - q of variance V. The result is the root of D^2 - E^2, negative where D < E: lost in the noise. V
// sums the squares of what each pixel adds to p - q, beyond its share of all events. Pixels are independent,
// but the events of one pixel are not, and x and ref share their thresholds. For one event per pixel, V is p
// (1 - p) / n_x + q (1 - q) / n_ref; for equal streams it is 0.
double phaseError(const PhasedEvents& x, const PhasedEvents& ref);

}  // namespace saccade::eval
