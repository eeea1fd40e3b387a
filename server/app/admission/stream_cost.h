// What one stream takes of the limits.
#pragma once

#include <vector>

#include "app/admission/resource_quota.h"
#include "app/request/resolve.h"

namespace saccade {

// Gives each sensor its share of the events that a frame may have, unless it asks for less. Throws
// LimitReached where it asks for more: it would not get the events it had elsewhere.
void boundEvents(ResolvedStream& stream, const Limits& limits);

// MiB, about: the most memory of a stream that looks through a view of its own, but for its queue.
double streamMemory(const ResolvedStream& stream);

std::vector<Share> sharesOf(const ResolvedStream& stream, const Limits& limits);

// Throws LimitReached: the request exceeds a limit that each stream has for itself.
void checkAlone(const v1::OpenStream& request, const Limits& limits);

}  // namespace saccade
