// The mean of what came last.
#pragma once

#include <algorithm>

namespace saccade {

// Of the first kSpan values as usual; then older ones fade by 1 / kSpan with each that comes.
class RecentMean {
 public:
  void add(double value) {
    weight_ = std::min(weight_ + 1, kSpan);
    mean_ += (value - mean_) / weight_;
  }
  double value() const { return mean_; }  // 0 before the first

 private:
  static constexpr int kSpan = 16;
  int weight_ = 0;
  double mean_ = 0;
};

}  // namespace saccade
