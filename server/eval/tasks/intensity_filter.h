// Log intensity from events, with frames or without.
//
// [S18] Scheerlinck, Barnes, Mahony, Continuous-time intensity estimation using event cameras, ACCV 2018.
#pragma once

#include <numbers>

#include "frame/image.h"
#include "saccade/wire/event.h"

namespace saccade::eval {

inline constexpr double kCrossover = 2 * std::numbers::pi;  // alpha, radians per second

// The complementary filter dL/dt = E - alpha (L - L_frame) [S18]. E are the events, each a pulse of the size
// of its threshold. So L follows the frames below alpha, and the events above. With frames of 0 it is the
// high-pass filter of [S18]. Exact: between events L decays towards L_frame as exp(-alpha t).
class IntensityFilter {
 public:
  // Begins at `t_s` with L = L_frame.
  IntensityFilter(const ImageF& L_frame, double t_s, double alpha = kCrossover);

  // Times never go back, seconds.
  void setFrame(const ImageF& L_frame, double t_s);
  void add(const Event& e, double threshold);
  double at(int x, int y, double t_s) const;

 private:
  double alpha_;
  ImageF L_frame_, L_;   // L at since_
  Image<double> since_;  // by pixel, seconds
};

}  // namespace saccade::eval
