// A method's output for the sensors: the change of intensity over one frame interval. Pure data.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "base/units.h"
#include "frame/image.h"

namespace saccade {

// The intensity of one pixel at a time inside an interval.
struct IntensityUpdate {
  std::uint32_t pixel;  // y * width + x
  float at;             // share of the interval that has passed, 0 < at < 1
  float I;              // D[I] >= 0
};

// All planes are width x height, Rec. 709 luminance.
struct IntensityChange {
  IntensityChange(int w, int h) : dI(w, h), I_prev(w, h), I_now(w, h), var_dI(w, h), var_I_prev(w, h) {}
  void copyFrom(const IntensityChange& other);

  TimeNs t0{0}, t1{0};   // the interval [t0, t1) between the two frames
  FrameIndex frame = 0;  // index of the frame at t1
  ImageF dI;             // D[I_t - I_{t-1}], any sign
  ImageF I_prev;         // D[I_{t-1}] >= 0, the denominator of [E (21)]
  ImageF I_now;          // D[I_t] >= 0
  ImageF var_dI;         // variance of dI, >= 0; 0 if the method does not estimate it
  ImageF var_I_prev;     // variance of I_prev, >= 0; 0 if the method does not estimate it
  // By `at`, then by pixel; no pair twice. The log brightness of a pixel is straight in time between two of
  // its updates, and so before the first and after the last.
  std::vector<IntensityUpdate> updates;
};

// All planes.
inline constexpr std::array kChangePlanes{&IntensityChange::dI, &IntensityChange::I_prev,
                                          &IntensityChange::I_now, &IntensityChange::var_dI,
                                          &IntensityChange::var_I_prev};

inline void IntensityChange::copyFrom(const IntensityChange& other) {
  t0 = other.t0, t1 = other.t1, frame = other.frame;
  for (const auto plane : kChangePlanes) (this->*plane).copyFrom(other.*plane);
  updates = other.updates;
}

}  // namespace saccade
