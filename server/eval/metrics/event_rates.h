// Computes the false and missed events of one frame. Method and reference have the same threshold phase in
// each pixel. Thresholds lie C apart, and the phase U in [0, C) is the distance to the next lower one [E
// (26)]. A change d crosses |floor((U + d) / C)| of them [E (27)]. An event is false if the reference has
// none at that phase, and missed if only the reference has it.
#pragma once

#include <cstdint>

#include "frame/image.h"

namespace saccade::eval {

// Means over the pixels of the frame.
struct EventRates {
  double false_events = 0, missed_events = 0;  // events per pixel-frame, >= 0: the headline
  double false_pixels = 0, missed_pixels = 0;  // share of pixel-frames with any such event, [0, 1]
};

// The mean over all phases, in closed form: free of sampling noise. Planes of dL, finite; C > 0.
EventRates integratedRates(const ImageF& dL, const ImageF& dL_ref, double C);

// Counted at one phase per pixel, drawn from `seed`, as in a single run.
EventRates sampledRates(const ImageF& dL, const ImageF& dL_ref, double C, std::uint64_t seed);

// The false events of a truth by its own noise, from the rates of one of its halves against the other. It has
// as many missed ones. The noise of the mean of both halves is half of their difference [E (32)].
inline double ownRate(const EventRates& of_halves) {
  return (of_halves.false_events + of_halves.missed_events) / 4;
}

// Of one pixel: events of the change d, in the mean over U, counted only where the change `ref` has none.
// With ref = 0 it is |d| / C [E (31)]. Swap d and ref for the missed ones.
double expectedFalseEvents(double d, double ref, double C);

}  // namespace saccade::eval
