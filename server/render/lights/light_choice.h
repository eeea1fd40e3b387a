// One of several lights, chosen with a probability that is proportional to its weight.
#pragma once

#include <algorithm>
#include <vector>

namespace saccade {

class LightChoice {
 public:
  LightChoice() = default;
  explicit LightChoice(const std::vector<float>& weights) {
    float sum = 0;
    for (const float weight : weights) sums_.push_back(sum += weight);
    if (sum <= 0) sums_.clear();
    inverse_weight_ = sum > 0 ? 1 / sum : 0;
    for (float& s : sums_) s /= sum;
  }

  bool empty() const { return sums_.empty(); }
  float inverseWeight() const { return inverse_weight_; }  // of all weights together; 0: all are 0
  // u: in [0, 1).
  std::size_t choose(float u) const {
    const auto i = static_cast<std::size_t>(std::upper_bound(sums_.begin(), sums_.end(), u) - sums_.begin());
    return std::min(i, sums_.size() - 1);
  }
  float probability(std::size_t i) const { return i == 0 ? sums_[0] : sums_[i] - sums_[i - 1]; }
  // The running sums of the probabilities, which rise to 1. Empty if all weights are 0.
  const std::vector<float>& sums() const { return sums_; }

 private:
  std::vector<float> sums_;
  float inverse_weight_ = 0;
};

}  // namespace saccade
