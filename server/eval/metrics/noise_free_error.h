// Compares estimates with two independent halves a and b of the truth, so that the noise of the truth
// cancels. The mean of (x - a)(x - b) over the noise of the halves is (x - truth)^2, and that of ab is
// truth^2.
#pragma once

#include "frame/image.h"

namespace saccade::eval {

// Sums over pixels, frames and repeats.
class NoiseFreeError {
 public:
  // Planes of one size and unit, finite.
  void add(const ImageF& x, const ImageF& a, const ImageF& b);

  // sqrt(<(x - a)(x - b)> / <ab>): the root mean square error over that of the truth. 1 is what an estimate
  // of 0 everywhere has. 0 where the error is lost in the noise. NaN where the truth is 0 or lost in the
  // noise.
  double relative() const;
  // <x (a + b) / 2> / <ab>: the share of the truth that arrives in the estimate. 1 is right, 0 is none; above
  // 1 it is exaggerated. Errors that do not go with the truth leave it as it is. NaN as above.
  double share() const;

 private:
  double error_ = 0, arrived_ = 0, truth_ = 0;
};

}  // namespace saccade::eval
