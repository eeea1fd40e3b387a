// The odds that an event is an artefact of rendering.
#pragma once

#include <cstdint>

#include "frame/intensity_change.h"
#include "wire/event.h"

namespace saccade {

// A pixel whose brightness seems to change by dL, with a standard deviation of sigma, sends |dL| / C events
// in the mean. Let the true change be normally distributed around dL. The events beyond the true change,
// towards dL, are false. Their share, for a = |dL| / sigma, a normal Z, its density phi and distribution Phi,
// is
//
//   E[clamp(sigma Z, 0, |dL|)] / |dL| = (phi(0) - phi(a)) / a + 1 - Phi(a)    [ours]
//
// It is 1/2 for a = 0 and falls as phi(0) / a. For small errors the false events per frame are thus
// phi(0) sigma / C: half of [E (32)], whose other half are missed events.
double artefactOdds(double dL, double sigma);

// Labels the events of an interval, in any order, with their odds. `dL`: the change of log brightness that
// they come from. `bias`: I_eps. sigma is that of dI over bias + I_prev; a method without variances gives
// odds of 0.
void labelArtefacts(const IntensityChange& change, float bias, const ImageF& dL, Events& events);

// Removes the events whose odds are above `most`. Returns their number.
std::uint64_t removeArtefacts(double most, Events& events);

}  // namespace saccade
