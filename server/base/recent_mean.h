// The mean of what came last.
#pragma once

#include <algorithm>

namespace saccade {

// Of the first values as usual; from the 16th on, older ones fade by a sixteenth with each that comes.
class RecentMean {
 public:
  void add(double value) {
    weight_ = std::min(weight_ + 1, 16);
    mean_ += (value - mean_) / weight_;
  }
  double value() const { return mean_; }  // 0 before the first

 private:
  int weight_ = 0;
  double mean_ = 0;
};

}  // namespace saccade
