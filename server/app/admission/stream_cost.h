// The amounts that one stream takes of the limits.
#pragma once

#include <string>
#include <vector>

#include "app/admission/resource_quota.h"
#include "app/request/resolved_stream.h"

namespace saccade {

// Gives each sensor its share of the limit `events`, unless it asks for less. Throws LimitReached where it
// asks for more: it would get other events than on a server that allows them.
void boundEvents(ResolvedStream& stream, const Limits& limits);

// Throws Refusal, naming a member of `field`, where a change gives a sensor more noise than its stream has
// room for. `sensor`: of `request`, with its bound. `first`: the noise that it has at first.
void checkChange(const v1::OpenStream& request, const v1::Sensor& sensor, const NoiseConfig& first,
                 const SensorChange& change, const std::string& field);

// Throws LimitReached where a frame has more rows of truth channels than the limit `rows`.
void boundRows(const ResolvedStream& stream, const Limits& limits);

// A stream that can be steered ends when its path has as many keys as a request may have. Throws LimitReached
// where it shall last longer.
void boundSteering(ResolvedStream& stream, const Limits& limits);

// MiB: an estimate of the most memory of a stream with a feed of its own, without its queue.
double streamMemory(const ResolvedStream& stream, const Limits& limits);

// MiB: the part of it that streams share which join one feed.
double feedMemory(const ResolvedStream& stream, const Limits& limits);

// But for its feed, and for its request: requestMemory() counts that before it is resolved.
std::vector<Share> sharesOf(const ResolvedStream& stream, const Limits& limits);

// Throws LimitReached where the request exceeds a limit of single streams.
void checkAlone(const v1::OpenStream& request, const Limits& limits);

}  // namespace saccade
