// The common part of channels that give a row for each object that moves, at each frame.
#pragma once

#include <vector>

#include "truth/truth_source.h"

namespace saccade {

class ObjectSource : public TruthSource {
 public:
  TruthSamples sample(const FeedInterval& interval) final;

 protected:
  // The numbers after that of the object.
  virtual std::vector<double> row(const Trajectory& path, TimeNs t) = 0;

 private:
  void add(const RenderedInterval& interval, TimeNs t, TruthSamples& samples);

  std::vector<std::uint32_t> numbers_;  // by body, once the scene is known
};

}  // namespace saccade
