// Decides whether PACED streams can keep their pace: the CPU time they take, and the CPU time there is.
#pragma once

#include <memory>

#include "app/admission/limits.h"
#include "app/request/resolved_stream.h"
#include "base/pool_handle.h"
#include "scene/camera/trajectory.h"

namespace saccade {

class RenderScene;

// CPU seconds, of a frame or of a second.
struct CpuCost {
  double feed = 0;           // until the change of every pixel is known, over all threads
  double sensors = 0;        // until that has become packets, over all threads
  double critical_path = 0;  // the part of `feed` that does not become shorter by more threads
  double longest = 0;        // the sensor that takes longest
};

// The cost of two streams that share a feed.
CpuCost together(const CpuCost& a, const CpuCost& b);

// Measures the cost of a frame. Renders a few steps of a rig of its own.
CpuCost measureFrame(const std::shared_ptr<const RenderScene>& scene, const Trajectory& body,
                     const ResolvedStream& stream, const PoolHandle& pool);

// The CPU time there is.
struct CpuSupply {
  double threads = 1;  // CPU seconds per second, all together
  double speed = 1;    // those of one thread
  double most = 1;     // `threads` where no other program wants any
};
CpuSupply cpuSupply(const TilePool& pool);  // by the CPUs there are, and what the pool got of them of late

// The load by PACED streams: their CPU time in a second, and their lag.
struct PaceLoad {
  double total = 0;  // CPU time of all of them
  CpuCost feed;      // that of the streams of one feed together
  double lag_s = 0;  // of the one that is furthest behind its clock
};

// A PACED stream that is further behind its clock says so in its packets, and no other is taken meanwhile.
inline constexpr double kMostLagSeconds = 1;

// Throws LimitReached unless a PACED stream of such frames fits beside the others. The CPU time of all must
// fit into the threads, and one frame after the other of its feed into its period. `taken.feed`: of the feed
// that the stream joins, and then `frame.feed` is 0. Such a stream is taken although others lag, and although
// other programs take CPU time.
void checkPace(const v1::Timing& timing, const CpuCost& frame, const PaceLoad& taken, const CpuSupply& lately,
               const Limits& limits);

}  // namespace saccade
