// The difference between the same surface points of both frames, which EventSVGF's appendix C proposes beside
// that between the same pixels.
#pragma once

#include "base/pool_handle.h"
#include "filter/demodulation.h"
#include "filter/filter_planes.h"
#include "frame/frame.h"

namespace saccade {

// d = i_t[s] - i_{t-1}[w(s)] [E (35)], of frames of SeedPlan::correlatedAlongMotion. Both samples have
// one point and its random numbers. w(s) is rounded to a pixel. 0 where it shows another surface.
std::chrono::nanoseconds alignDifference(const FramePair& frames, Demodulation by, const PoolHandle& pool,
                                         ImageF& d);

// Makes the filtered difference along the motion that at the same pixel: adds i_{t-1}[w(s)] - i_{t-1}[s]
// [E (39)]. `i_prev`: the filtered light of the frame before. A surface that has appeared takes the
// difference of filtered light.
std::chrono::nanoseconds correctAlignment(const FramePair& frames, const ImageF& i_prev,
                                          const PoolHandle& pool, FilterPlanes& filtered);

}  // namespace saccade
