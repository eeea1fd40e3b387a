// The CPU time of a setting at other sizes and lengths than the measured ones [ours].
//
// The time of a frame is a fixed part and a part per pixel: t(p) = a + b p. Two sizes tell both. Methods that
// keep light take longer in the first frames, until they know the scene. The mean over N frames falls by
// f(N) = r + (1 - r) L / max(N, L). Here r is the time of late frames over that of the first L.
#pragma once

#include <limits>

namespace saccade {

// CPU milliseconds per frame, over all threads. NaN: not measured.
struct MeasuredTime {
  double first_ms = 0;                                              // mean over frames 1 to L
  double small_ms = std::numeric_limits<double>::quiet_NaN();       // the same at a quarter of the pixels
  double small_late_ms = std::numeric_limits<double>::quiet_NaN();  // there, of frames 3 L + 1 to 4 L
};
inline constexpr int kLateFrames = 4;  // the late frames end at this many times L

// The mean over the frames of a stream, with `pixels` times the measured ones and `length` times L. `length`
// may be infinite, and counts as 1 below that. Where only first_ms is known, time grows with the pixels.
double timeAt(const MeasuredTime& measured, double pixels, double length);

}  // namespace saccade
