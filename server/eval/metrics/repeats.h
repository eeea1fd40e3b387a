// Mean and noise of one frame that was estimated repeatedly with different seeds.
#pragma once

#include "frame/image.h"

namespace saccade::eval {

class Repeats {
 public:
  Repeats(int width, int height) : mean_(width, height), squares_(width, height) {}

  // The plane of one more repeat: dL, or any other.
  void add(const ImageF& x);

  int count() const { return count_; }
  int width() const { return mean_.width(); }
  int height() const { return mean_.height(); }

  double mean(int x, int y) const { return mean_.at(x, y); }
  // Of a single repeat, unbiased. Needs two repeats or more.
  double variance(int x, int y) const;
  // Its square root: sigma_dL. Of n repeats it comes out too small by about 1 / (4 n) of itself.
  ImageF sigma() const;

 private:
  int count_ = 0;
  Image<double> mean_, squares_;  // squares: sum of (x - mean)^2
};

}  // namespace saccade::eval
