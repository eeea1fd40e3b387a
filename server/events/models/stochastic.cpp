// Accumulating, where the level also moves at random. So noise events depend on threshold and slope, and
// reset the pixel. [DVS-Voltmeter, Lin et al., ECCV 2022, eqs. 10 and 11]
//
// v is a Brownian motion with the drift dL/dt. An event comes at its first passage through C+ or -C-. On a
// still picture the mean time to it is C+ C- / s^2. So the variance per second at the reference luminance R
// is
//
//   s^2 = brownian_hz C+ C-,    and at intensity I    s^2(I) = s^2 R / max(I + dark_luminance, R / 10).
//
// The published s(L) is K3 sqrt(L) / (L + K2) + K6; this is its square where L is large, without K6. The
// floor is ours, as that of the photoreceptor.
#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>
#include <vector>

#include "base/hash_rng.h"
#include "base/tile_pool.h"
#include "events/event_bounds.h"
#include "events/models/first_passage.h"
#include "events/models/models.h"
#include "events/pixel_thresholds.h"

namespace saccade {
namespace {

class Stochastic final : public EventModel {
 public:
  Stochastic(const SensorConfig& config, int width, int height)
      : config_(config),
        thresholds_(config, width, height),
        bounds_(config, static_cast<std::size_t>(width) * height),
        v_(width, height),
        awake_ns_(config.refractory > TimeNs(0) ? static_cast<std::size_t>(width) * height : 0) {
    if (!config.random_start) return;
    forEachPixel([&](int x, int y) {
      const double on = thresholds_.on(x, y), off = thresholds_.off(x, y);
      v_.at(x, y) = inside(x, y, -off + toUnit(hashKey(config.seed, indexOf(x, y))) * (on + off));
    });
  }

  void see(const ImageF& I_now) override { I_now_ = &I_now; }

  std::uint64_t generate(const ImageF& dL, const Interval& interval, Events& events) override {
    begin(interval, events);
    forEachPixel([&](int x, int y) { move(x, y, I_now_->at(x, y), dL.at(x, y), 0, 1, events); });
    return bounds_.suppressed();
  }

  void begin(const Interval& interval, Events& events) override {
    interval_ = interval;
    length_ns_ = static_cast<double>((interval.t1 - interval.t0).count());
    key_ = hashKey(hashKey(config_.seed, 1), interval.frame);
    bounds_.begin(false);
    if (!std::exchange(changed_, false)) return;
    forEachPixel([&](int x, int y) {
      float& v = v_.at(x, y);
      if (v >= thresholds_.lowest(x, y) && v <= thresholds_.highest(x, y)) return;
      send(x, y, v > 0, 0, events);
      v = 0;
    });
  }

  void advance(const Pieces& pieces, Events& events) override {
    TilePool::yieldToHighPriority();
    for (int i = 0; i < pieces.count; ++i)
      move(pieces.x[i], pieces.y[i], pieces.I[i], pieces.dL[i], pieces.from[i], pieces.to[i], events);
  }

  std::uint64_t end(const ImageF& dL, const ImageF& from, Events& events) override {
    forEachPixel([&](int x, int y) { move(x, y, I_now_->at(x, y), dL.at(x, y), from.at(x, y), 1, events); });
    return bounds_.suppressed();
  }

  void setThresholds(const SensorConfig& config) override {
    config_ = config;
    thresholds_ = OwnThresholds(config, v_.width(), v_.height());
    changed_ = true;
  }

  float level(int x, int y) const override { return v_.at(x, y); }

 private:
  template <class F>
  void forEachPixel(F&& f) {
    for (int y = 0; y < v_.height(); ++y) {
      TilePool::yieldToHighPriority();
      for (int x = 0; x < v_.width(); ++x) f(x, y);
    }
  }
  std::size_t indexOf(int x, int y) const { return static_cast<std::size_t>(y) * v_.width() + x; }
  float inside(int x, int y, double v) const {
    return std::clamp(static_cast<float>(v), thresholds_.lowest(x, y), thresholds_.highest(x, y));
  }

  // Per second, at intensity I.
  double varianceAt(float I) const {
    const NoiseConfig& noise = config_.noise;
    const double R = noise.reference_luminance;
    const double light = (I - I == 0 ? I : 0) + noise.dark_luminance;
    return noise.brownian_hz * config_.threshold * config_.threshold_off * R /
           std::max(light, R / kMostBrownian);
  }

  // Moves a pixel by `change` from one share of the interval to another.
  void move(int x, int y, float I, double change, double from, double to, Events& events) {
    const double variance = varianceAt(I) * length_ns_ * 1e-9, speed = change / (to - from);
    NumberRow numbers(hashKey(hashKey(key_, indexOf(x, y)), std::bit_cast<std::uint64_t>(to)));
    float& v = v_.at(x, y);
    double at = std::max(from, awakeAt(x, y));
    while (at < to) {
      const double rest = to - at;
      const Passage passage =
          firstPassage({static_cast<double>(v), speed * rest, variance * rest}, thresholds_.on(x, y),
                       thresholds_.off(x, y), 1 / (length_ns_ / kEventTimeUnit.count() * rest), numbers);
      v = passage.crosses ? 0 : inside(x, y, passage.level);
      at += passage.at * rest;
      if (!passage.crosses) return;
      if (!send(x, y, passage.level > 0, at, events)) return skip(x, y, speed * (to - at));
      at = std::max(at, awakeAt(x, y));
    }
  }

  // A pixel that may send no more is moved by its drift alone: in time that does not grow with it.
  void skip(int x, int y, double change) {
    const double C = change > 0 ? thresholds_.on(x, y) : thresholds_.off(x, y);
    bounds_.suppress(static_cast<std::uint64_t>(std::abs(change) / C));
    v_.at(x, y) = inside(x, y, std::fmod(change, C));
  }

  // As a share of the interval.
  double awakeAt(int x, int y) const {
    if (awake_ns_.empty()) return 0;
    return static_cast<double>(awake_ns_[indexOf(x, y)] - interval_.t0.count()) / length_ns_;
  }

  // Whether a bound lets the event pass.
  bool send(int x, int y, bool on, double at, Events& events) {
    const std::int64_t ticks = (interval_.t1 - interval_.t0) / kEventTimeUnit;
    const auto tick = std::min(static_cast<std::int64_t>(at * static_cast<double>(ticks)), ticks - 1);
    const std::int64_t t_ns = (interval_.t0 + tick * kEventTimeUnit).count();
    if (!awake_ns_.empty())
      awake_ns_[indexOf(x, y)] =
          interval_.t0.count() + std::llround(at * length_ns_) + config_.refractory.count();
    if (bounds_.take(indexOf(x, y), 1) == 0) return false;
    events.push_back({t_ns, static_cast<std::uint16_t>(x), static_cast<std::uint16_t>(y), on});
    return true;
  }

  SensorConfig config_;
  OwnThresholds thresholds_;
  EventBounds bounds_;
  ImageF v_;
  std::vector<std::int64_t> awake_ns_;  // of each pixel; empty without refractory period
  const ImageF* I_now_ = nullptr;
  Interval interval_{};
  double length_ns_ = 0;
  std::uint64_t key_ = 0;
  bool changed_ = false;  // the thresholds, since the last interval
};

}  // namespace

std::unique_ptr<EventModel> makeStochastic(const SensorConfig& config, int width, int height) {
  if (config.noise.brownian_hz == 0) return makeAccumulating(config, width, height);
  return std::make_unique<Stochastic>(config, width, height);
}

}  // namespace saccade
