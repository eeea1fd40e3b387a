#include "render/lights/lamp_sight.h"

#include <algorithm>

namespace saccade {
namespace {

constexpr std::size_t kFewest = 8;  // samples of a box
constexpr int kDeepest = 10;
constexpr float kLeastGain = 0.02f;  // of a split, over the samples

// How many samples of each group could see it, and did.
class Counts {
 public:
  void add(const SightSample& sample, float n) {
    for (std::size_t k = 0; k < kLampGroups; ++k) {
      if (sample.seen[k] != SightSample::kNothing) could_[k] += n;
      if (sample.seen[k] == SightSample::kLamp) did_[k] += n;
    }
  }
  // The sum of squared errors of the shares.
  float variance() const {
    float sum = 0;
    for (std::size_t k = 0; k < kLampGroups; ++k)
      if (could_[k] > 0) sum += did_[k] * (could_[k] - did_[k]) / could_[k];
    return sum;
  }
  LampSight::Shares shares() const {
    LampSight::Shares shares;
    for (std::size_t k = 0; k < kLampGroups; ++k) shares.of[k] = could_[k] > 0 ? did_[k] / could_[k] : 1;
    return shares;
  }

 private:
  std::array<float, kLampGroups> could_{}, did_{};
};

Counts countsOf(std::span<const SightSample> samples) {
  Counts all;
  for (const SightSample& s : samples) all.add(s, 1);
  return all;
}

}  // namespace

LampSight::LampSight(std::vector<SightSample> samples) {
  if (samples.size() < kFewest ||
      countsOf(samples).variance() < kLeastGain * static_cast<float>(samples.size()))
    return;
  nodes_.push_back({});
  divide(0, samples, 0);
}

void LampSight::divide(std::uint32_t node, std::span<SightSample> samples, int depth) {
  const Counts all = countsOf(samples);
  struct Best {
    float variance, plane = 0;
    std::uint32_t axis = kBox;
  };
  Best best{all.variance() - kLeastGain * static_cast<float>(samples.size())};
  const auto along = [&](std::uint32_t axis) {
    std::stable_sort(samples.begin(), samples.end(), [&](const SightSample& a, const SightSample& b) {
      return coordinate(a.at, axis) < coordinate(b.at, axis);
    });
  };
  for (std::uint32_t axis = 0; axis < kBox && depth < kDeepest; ++axis) {
    along(axis);
    Counts below, above = all;
    for (std::size_t i = 1; i < samples.size(); ++i) {
      below.add(samples[i - 1], 1), above.add(samples[i - 1], -1);
      const float low = coordinate(samples[i - 1].at, axis), high = coordinate(samples[i].at, axis);
      if (i < kFewest || samples.size() - i < kFewest || low == high) continue;
      if (const float left = below.variance() + above.variance(); left < best.variance)
        best = {left, (low + high) / 2, axis};
    }
  }
  if (best.axis == kBox) {
    nodes_[node] = {0, kBox, static_cast<std::uint32_t>(boxes_.size())};
    return boxes_.push_back(all.shares());
  }
  const auto next = static_cast<std::uint32_t>(nodes_.size());
  nodes_[node] = {best.plane, best.axis, next};
  nodes_.push_back({}), nodes_.push_back({});
  const auto above = std::stable_partition(samples.begin(), samples.end(), [&](const SightSample& s) {
    return coordinate(s.at, best.axis) < best.plane;
  });
  const auto below = static_cast<std::size_t>(above - samples.begin());
  divide(next, samples.first(below), depth + 1);
  divide(next + 1, samples.subspan(below), depth + 1);
}

}  // namespace saccade
