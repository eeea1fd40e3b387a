// The pieces of log brightness of an interval, from its updates.
#pragma once

#include <cstddef>

#include "events/pieces.h"
#include "frame/image.h"
#include "frame/intensity_change.h"

namespace saccade {

// An interval is begin(), correct() where a reconstruction has changed its response, next() until there are
// no more, last(). Nothing allocates.
class BrightnessPieces {
 public:
  BrightnessPieces(int width, int height) : I_(width, height), from_(width, height), slope_(width, height) {}

  // `change`, whose updates keep the promises of IntensityChange, outlives the interval. `bias`: I_eps. `dL`:
  // the log response of the change.
  void begin(const IntensityChange& change, float bias, const ImageF& dL);

  // The change over the interval becomes `dL`. The difference is a ramp over the interval.
  void correct(const ImageF& dL);

  // The next pieces, which end with an update; nullptr after the last. They may be changed in place. An
  // update whose I is NaN or Inf changes nothing.
  Pieces* next();

  // Replaces the change over the interval by that from the last update to t1, where a pixel has updates.
  void last(ImageF& dL) const;
  // The shares of the interval at which these pieces begin; 0 without updates.
  const ImageF& from() const { return from_; }

 private:
  void take(const IntensityUpdate* updates, std::size_t count);

  const IntensityChange* change_ = nullptr;
  float bias_ = 0;
  bool corrected_ = false;
  std::size_t taken_ = 0;  // so many updates
  ImageF I_, from_;        // intensity and share of the last update; of t0 without one
  ImageF slope_;           // of the ramp, log brightness per interval
  Pieces pieces_;
};

}  // namespace saccade
