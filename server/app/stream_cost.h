// What one stream takes of the limits.
#pragma once

#include <vector>

#include "app/budget.h"
#include "app/resolve.h"

namespace saccade {

// Gives each sensor its share of the events that a frame may have, unless it asks for less. Throws
// LimitReached where it asks for more: it would not get the events it had elsewhere.
void boundEvents(ResolvedStream& stream, const Limits& limits);

// MiB, about: the most memory of a stream that looks through a view of its own, but for its queue.
double streamMemory(const ResolvedStream& stream);

std::vector<Share> sharesOf(const ResolvedStream& stream, const Limits& limits);

// Throws LimitReached: the request exceeds a limit that each stream has for itself.
void checkAlone(const v1::OpenStream& request, const Limits& limits);

// CPU seconds, of a frame or of a second, over all threads.
struct CpuCost {
  double feed = 0;     // until the change of every pixel is known
  double sensors = 0;  // until that has become packets
};

// Of a frame. Renders a few of a feed that is then thrown away: that of the stream is not touched.
CpuCost measureFrame(std::shared_ptr<const RenderScene> scene, const Trajectory& path,
                     const ResolvedStream& stream, TilePool& pool);

// Throws LimitReached unless a PACED stream of such frames fits beside what others take. `frame.feed` is 0
// where the stream joins a feed that runs already. `taken`: CPU seconds per second; `threads`: that there
// are.
void checkPace(const v1::Timing& timing, const CpuCost& frame, double taken, double threads,
               const Limits& limits);

}  // namespace saccade
