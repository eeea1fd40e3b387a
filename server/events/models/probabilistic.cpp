// Stochastic generation (paper, 4.6): a threshold phase uniform in [0, C), fresh for every pixel and frame,
// so that E[K] = |dL| / C [E (31)]. Each piece of a pixel has a fresh phase, so that E[K] is the sum over
// the pieces. Between frames it keeps only which pixels are blind.
#include <bit>

#include "base/hash_rng.h"
#include "base/tile_pool.h"
#include "events/models/models.h"
#include "events/threshold_pixels.h"

namespace saccade {
namespace {

// Calls f(x, y, dL) where dL is not 0, row by row. Blocks without a change are skipped fast.
template <class F>
void forEachChange(const ImageF& dL, F&& f) {
  constexpr int kBlock = 16;
  for (int y = 0; y < dL.height(); ++y) {
    TilePool::yieldToHighPriority();
    const float* row = dL.row(y);
    // The last block may reach into the border, which is 0.
    for (int x0 = 0; x0 < dL.width(); x0 += kBlock) {
      std::uint32_t bits = 0;
      for (int i = 0; i < kBlock; ++i) bits |= std::bit_cast<std::uint32_t>(row[x0 + i]);
      if (bits == 0) continue;
      for (int x = x0; x < x0 + kBlock; ++x) {
        if (row[x] != 0) f(x, y, row[x]);
      }
    }
  }
}

template <class Thresholds>
class Probabilistic final : public EventModel {
 public:
  Probabilistic(const SensorConfig& config, int width, int height)
      : seed_(config.seed), width_(width), pixels_(config, width, height) {}

  std::uint64_t generate(const ImageF& dL, const Interval& interval, Events& events) override {
    pixels_.begin(interval, true);
    key_ = hashKey(seed_, interval.frame);
    forEachChange(dL, [&](int x, int y, float change) { move(x, y, change, keyOf(x, y), {}, events); });
    return pixels_.suppressed();
  }

  void begin(const Interval& interval, Events&) override {
    pixels_.begin(interval, false);
    key_ = hashKey(seed_, interval.frame);
  }

  void advance(const Pieces& pieces, Events& events) override {
    TilePool::yieldToHighPriority();
    for (int i = 0; i < pieces.count; ++i) {
      if (pieces.dL[i] == 0) continue;
      const int x = pieces.x[i], y = pieces.y[i];
      const std::uint64_t key = hashKey(keyOf(x, y), std::bit_cast<std::uint32_t>(pieces.to[i]));
      move(x, y, pieces.dL[i], key, {pieces.from[i], pieces.to[i]}, events);
    }
  }

  std::uint64_t end(const ImageF& dL, const ImageF& from, Events& events) override {
    forEachChange(dL, [&](int x, int y, float change) {
      move(x, y, change, keyOf(x, y), {from.at(x, y), 1}, events);
    });
    return pixels_.suppressed();
  }

  // The phase is fresh in each interval: no pixel lies outside.
  void setThresholds(const SensorConfig& config) override { pixels_.setThresholds(config); }

  float level(int, int) const override { return 0; }

 private:
  // Of the numbers of a pixel in this interval.
  std::uint64_t keyOf(int x, int y) const {
    return hashKey(key_, static_cast<std::uint64_t>(y) * width_ + x);
  }

  void move(int x, int y, float change, std::uint64_t number, typename ThresholdPixels<Thresholds>::Part part,
            Events& events) {
    // 53 bits: with the steps of a float E[K] of a small change would be wrong.
    const double u = static_cast<double>(number >> 11) * 0x1p-53;
    const double C = pixels_.threshold(x, y, change), phase = change > 0 ? u * C : -u * C;
    pixels_.advance(x, y, phase, change, part, events);
  }

  std::uint64_t seed_, key_ = 0;
  int width_;
  ThresholdPixels<Thresholds> pixels_;
};

}  // namespace

std::unique_ptr<EventModel> makeProbabilistic(const SensorConfig& config, int width, int height) {
  if (config.noise.mismatch > 0) {
    return std::make_unique<Probabilistic<OwnThresholds>>(config, width, height);
  }
  return std::make_unique<Probabilistic<EqualThresholds>>(config, width, height);
}

}  // namespace saccade
