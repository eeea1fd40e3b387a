#include "eval/metrics/timed_events.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

#include "base/hash_rng.h"

namespace saccade::eval {
namespace {

constexpr std::uint64_t kSeed = 7;

// Takes the events of a pixel off the front.
std::span<const TimedEvent> take(std::span<const TimedEvent>& all, std::uint32_t pixel) {
  const auto end = std::ranges::find_if(all, [&](const TimedEvent& e) { return e.pixel != pixel; });
  const auto count = static_cast<std::size_t>(end - all.begin());
  const auto taken = all.first(count);
  all = all.subspan(count);
  return taken;
}

std::vector<double> timesOf(std::span<const TimedEvent> events, bool on) {
  std::vector<double> times;
  for (const TimedEvent& e : events)
    if (e.on == on) times.push_back(e.time);
  return times;
}

}  // namespace

LineSensor::LineSensor(std::size_t pixels, double threshold) : threshold_(threshold), level_(pixels) {
  for (std::size_t i = 0; i < pixels; ++i)
    level_[i] = threshold * (2 * static_cast<double>(toUnit(hashKey(kSeed, i))) - 1);
}

void LineSensor::move(std::uint32_t pixel, double t0, double t1, double change) {
  if (change == 0) return;
  double& level = level_[pixel];
  const double sign = change > 0 ? 1 : -1, length = std::abs(change), first = threshold_ - sign * level;
  if (length < first) {
    level += change;
    return;
  }
  double passed = first;
  for (; passed <= length; passed += threshold_)
    events_.push_back({pixel, t0 + (t1 - t0) * passed / length, change > 0});
  level = sign * (length - (passed - threshold_));
}

std::vector<TimedEvent> LineSensor::events() const {
  std::vector<TimedEvent> sorted = events_;
  std::ranges::stable_sort(sorted, {}, &TimedEvent::pixel);
  return sorted;
}

TimedScore scoreEvents(const std::vector<TimedEvent>& events, const std::vector<TimedEvent>& truth,
                       double window) {
  TimedScore score;
  std::span<const TimedEvent> left = events, left_of_truth = truth;
  double pairs = 0;
  while (!left.empty() || !left_of_truth.empty()) {
    const std::uint32_t pixel = std::min(left.empty() ? UINT32_MAX : left[0].pixel,
                                         left_of_truth.empty() ? UINT32_MAX : left_of_truth[0].pixel);
    const auto of_pixel = take(left, pixel), true_of_pixel = take(left_of_truth, pixel);
    for (const bool on : {false, true}) {
      const std::vector<double> times = timesOf(of_pixel, on), true_times = timesOf(true_of_pixel, on);
      std::map<std::int64_t, int> surplus;  // by window
      for (const double t : times) ++surplus[static_cast<std::int64_t>(t / window)];
      for (const double t : true_times) --surplus[static_cast<std::int64_t>(t / window)];
      for (const auto& [_, count] : surplus)
        (count > 0 ? score.false_events : score.missed) += std::abs(count);
      for (std::size_t k = 0; k < std::min(times.size(), true_times.size()); ++k, ++pairs)
        score.time_error += std::abs(times[k] - true_times[k]);
    }
  }
  const auto all = std::max<double>(1, static_cast<double>(truth.size()));
  score.false_events /= all, score.missed /= all;
  if (pairs > 0) score.time_error /= pairs;
  return score;
}

}  // namespace saccade::eval
