// The odds that an event is an artefact of rendering.
#pragma once

#include <cstdint>

#include "frame/intensity_change.h"
#include "saccade/wire/event.h"

namespace saccade {

// A pixel whose brightness seems to change by dL sends |dL| / C events in the mean. The events beyond the
// true change, towards dL, are false. Let true changes be normally distributed around 0, with deviation tau,
// and errors with deviation sigma. Then the true change of this pixel is normally distributed around kappa
// dL, with kappa = tau^2 / (tau^2 + sigma^2), and variance kappa sigma^2. The share of false events is
//
//   E[clamp(dL - truth, 0, dL)] / dL    for dL > 0    [ours]
//
// It is 0 without error, and nears 1 where errors are much larger than dL, and dL than true changes. For tau
// without bound it falls as phi(0) sigma / |dL|. That makes phi(0) sigma / C false events per frame, half of
// [E (32)], whose other half are missed events. `tau` may be infinite. `sigma` that is 0 or NaN gives 0.
double artefactOdds(double dL, double sigma, double tau);

// Labels the events of an interval, in any order, with their odds. `dL`: the change of log brightness that
// they come from; where that is straight in pieces, the sum of their |dL|. `bias`: I_eps. tau^2 is the mean
// of dL^2 over the 3x3 pixels around the event, with its errors. (Less their variance, odds are too high
// where errors prevail.) A mean over the same pixels gives
//
//   sigma^2 = mean(var_dI + (I_now - I_prev - dI)^2) / (I_eps + max(0, I_prev + dI))^2    [ours]
//
// divided by the brightness of the event's own pixel. A variance knows nothing of blur. But dI is filtered by
// itself in EventSVGF, and blurred otherwise than the two pictures, so that they disagree where it matters.
// Methods that subtract filtered pictures have only their variance, or odds of 0.
void labelArtefacts(const IntensityChange& change, float bias, const ImageF& dL, Events& events);

// Removes the events whose odds are above `most`. Returns their number.
std::uint64_t removeArtefacts(double most, Events& events);

}  // namespace saccade
