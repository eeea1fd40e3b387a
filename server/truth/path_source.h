// The common part of channels that give one row of a frame, from the path of the camera.
#pragma once

#include <vector>

#include "truth/truth_source.h"

namespace saccade {

class PathSource : public TruthSource {
 public:
  TruthSamples sample(const FeedInterval& interval) final;

 protected:
  virtual std::vector<double> row(const Trajectory& path, TimeNs t) = 0;
};

}  // namespace saccade
