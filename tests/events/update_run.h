// Drives a sensor with pictures whose brightness a test gives as a formula, in intervals with updates or in
// whole frames.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <tuple>

#include "events/sensor.h"

namespace saccade::test {

inline constexpr TimeNs kInterval{16'000'000};

struct UpdateRun {
  // Log brightness log(I_eps + I) of pixel (x, y) at t, in intervals.
  using Brightness = std::function<double(int x, int y, double t)>;

  UpdateRun(const SensorConfig& config, int width, int height, Brightness L)
      : sensor(config, width, height), change(width, height), bias(config.bias), L(std::move(L)) {}

  float intensity(int x, int y, double t) const { return static_cast<float>(std::exp(L(x, y, t)) - bias); }

  // The next 1 / `parts` of an interval.
  void whole(int parts = 1) {
    begin(parts);
    generate();
  }
  // The next interval, with updates at k / `parts` where `has(x, y, k)`, 0 < k < parts.
  template <class F>
  void updated(int parts, F&& has) {
    const double t0 = now;
    begin(1);
    for (int k = 1; k < parts; ++k)
      for (std::uint32_t i = 0; i < pixels(); ++i) {
        const int x = static_cast<int>(i) % width(), y = static_cast<int>(i) / width();
        const double at = static_cast<double>(k) / parts;
        if (has(x, y, k)) change.updates.push_back({i, static_cast<float>(at), intensity(x, y, t0 + at)});
      }
    generate();
  }
  void updated(int parts) {
    updated(parts, [](int, int, int) { return true; });
  }

  int width() const { return change.dI.width(); }
  std::uint32_t pixels() const { return static_cast<std::uint32_t>(width() * change.dI.height()); }

  Sensor sensor;
  IntensityChange change;
  SensorOutput out;
  Events all;
  std::uint64_t suppressed = 0;
  double bias;
  Brightness L;
  double now = 0;  // in intervals

 private:
  void begin(int parts) {
    const double next = now + 1.0 / parts;
    change.t0 = change.t1, change.t1 += kInterval / parts;
    ++change.frame;
    change.updates.clear();
    for (int y = 0; y < change.dI.height(); ++y)
      for (int x = 0; x < width(); ++x) {
        change.I_prev.at(x, y) = intensity(x, y, now), change.I_now.at(x, y) = intensity(x, y, next);
        change.dI.at(x, y) = change.I_now.at(x, y) - change.I_prev.at(x, y);
      }
    now = next;
  }
  void generate() {
    sensor.generate(change, out);
    all.insert(all.end(), out.events.begin(), out.events.end());
    suppressed += out.suppressed;
  }
};

// Equal in number, place and polarity, and in time and odds within rounding.
inline testing::AssertionResult alike(Events a, Events b) {
  if (a.size() != b.size()) return testing::AssertionFailure() << a.size() << " and " << b.size();
  const auto earlier = [](const Event& l, const Event& r) {
    const auto key = [](const Event& e) {
      return std::tuple<int, int, std::int64_t, int>(e.y, e.x, e.t_ns, e.p);
    };
    return key(l) < key(r);
  };
  std::ranges::sort(a, earlier), std::ranges::sort(b, earlier);
  for (std::size_t i = 0; i < a.size(); ++i) {
    const bool same = a[i].x == b[i].x && a[i].y == b[i].y && a[i].p == b[i].p &&
                      std::abs(a[i].artefact - b[i].artefact) <= 1;
    if (!same || std::abs(a[i].t_ns - b[i].t_ns) > kEventTimeUnit.count())
      return testing::AssertionFailure() << "event " << i << " at " << a[i].x << ", " << a[i].y << ", "
                                         << a[i].t_ns << " and " << b[i].t_ns << " ns";
  }
  return testing::AssertionSuccess();
}

}  // namespace saccade::test
