// The parts of a request that resolve() and resolvePushed() share.
#pragma once

#include <string>

#include "app/request/resolved_stream.h"

namespace saccade {

// They throw Refusal.
void resolveTiming(ResolvedStream& stream);
void resolveRates(ResolvedStream& stream);  // of the timing: how often it is rendered
void resolveSensors(ResolvedStream& stream);
void resolveRefinement(ResolvedStream& stream);  // after the timing, the sensors, the method and the quality
void resolveTruths(ResolvedStream& stream);
void resolveDelivery(v1::OpenStream& request);

// The name of a view in refusals.
std::string viewField(std::size_t view);
// Finds where the cameras are on the body, and checks that sensors and truth channels name a view of the
// stream. Throws Refusal.
void resolveMounts(ResolvedStream& stream);
// Renders the further views as view 0, with random numbers of their own.
void shareSettings(ResolvedStream& stream);

}  // namespace saccade
