// A random walk of which any step can be asked for.
#pragma once

#include <cstdint>
#include <vector>

namespace saccade {

// Standard normal: equal for equal keys.
double normalAt(std::uint64_t key);

// The place after so many independent steps of variance 1, from 0: equal for equal keys, whatever was asked
// before. Levy's construction of Brownian motion halves intervals, and the intervals around the last step are
// kept. The next step costs two normal numbers on average, and any other one at most 40.
class RandomWalk {
 public:
  explicit RandomWalk(std::uint64_t key);

  double at(std::uint64_t step);  // 0 <= step < 2^40

 private:
  // The walk at both ends of [begin, begin + span).
  struct Interval {
    std::uint64_t begin, span, number;  // the halves of n have the numbers 2 n and 2 n + 1
    double left, right;
    bool holds(std::uint64_t step) const { return step - begin < span; }
  };
  Interval halfOf(const Interval& whole, std::uint64_t step) const;

  std::uint64_t key_;
  std::vector<Interval> path_;  // from all of the walk to the interval that begins with the last step
};

}  // namespace saccade
