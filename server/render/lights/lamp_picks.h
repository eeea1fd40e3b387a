// Which of many lamps without extent a point of a surface asks for.
#pragma once

#include <array>
#include <cstdint>
#include <span>

namespace saccade {

// All, if they are few. Else the strongest that have a hundredth of all weights, and some of the others, each
// in proportion to its weight. Those stand for all others, so that the mean is right. Equal numbers give
// equal lamps at points that are close together, nearly always.
class LampPicks {
 public:
  static constexpr std::size_t kMost = 256;  // lamps
  static constexpr std::size_t kStrongest = 16;

  struct Pick {
    std::uint32_t lamp;
    float factor;  // of its light
  };

  void clear() { count_ = 0; }
  // In order of lamps, at most kMost. `weight`: about what the lamp gives, above 0.
  void add(std::uint32_t lamp, float weight) { all_[count_++] = {lamp, weight}; }
  // Of what was added since clear(). `u`: in [0, 1).
  std::span<const Pick> choose(float u);

 private:
  struct Weighted {
    std::uint32_t lamp;
    float weight;
  };
  struct Least {
    float weight;
    std::size_t count;  // of the strongest with this weight
  };
  static constexpr std::size_t kMostOthers = 16;

  Least leastOfStrongest();
  void chooseOthers(std::span<const Weighted> others, float u);

  std::size_t count_ = 0, picked_ = 0;
  std::array<Weighted, kMost> all_;
  std::array<float, kMost> sorted_;
  std::array<Pick, kStrongest + kMostOthers> picks_;
};

}  // namespace saccade
