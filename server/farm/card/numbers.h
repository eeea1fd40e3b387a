// Numbers of which the card tells the least, the middle and the greatest, and how they are spread.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace saccade::farm {

class Numbers {
 public:
  void add(double number) { all_.push_back(number); }
  bool empty() const { return all_.empty(); }

  static constexpr std::size_t kBins = 12;
  struct Summary {
    double min = 0, median = 0, max = 0;
    std::array<std::uint64_t, kBins> bins = {};  // of equal width from min to max
  };
  // The median of an even count is the mean of the middle two. There is at least one number.
  Summary summary() const;

 private:
  std::vector<double> all_;
};

}  // namespace saccade::farm
