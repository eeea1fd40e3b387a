// A running mean that follows recent values.
#pragma once

#include <algorithm>

namespace saccade {

// The plain mean of the first kSpan values; then an exponential moving average with weight 1 / kSpan.
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
