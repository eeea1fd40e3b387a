#include "eval/metrics/stream_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "eval/metrics/for_each_pixel.h"
#include "eval/metrics/nearest_event.h"

namespace saccade::eval {
namespace {

EventPlace placeOf(const Event& e, std::int64_t begin_ns) {
  constexpr float kPolarity = 100;  // pixels between ON and OFF
  return {static_cast<float>(e.x), static_cast<float>(e.y),
          static_cast<float>(static_cast<double>(e.t_ns - begin_ns) * 1e-6), kPolarity * e.p};
}

std::vector<EventPlace> placesOf(const Events& events, std::int64_t begin_ns) {
  std::vector<EventPlace> places;
  places.reserve(events.size());
  for (const Event& e : events) places.push_back(placeOf(e, begin_ns));
  return places;
}

// As PECS scales them.
std::vector<EventPlace> scaled(std::vector<EventPlace> places) {
  constexpr EventPlace kSize{100, 100, 1000, 100};
  for (std::size_t i = 0; i < kSize.size(); ++i) {
    const auto less = [i](const EventPlace& p, const EventPlace& q) { return p[i] < q[i]; };
    const auto [low, high] = std::minmax_element(places.begin(), places.end(), less);
    const float from = (*low)[i], scale = kSize[i] / ((*high)[i] - from + 1e-8f);
    for (EventPlace& place : places) place[i] = (place[i] - from) * scale;
  }
  return places;
}

// Calls take(d) with the distance of each place to the nearest of `others`.
template <class Take>
void forEachDistance(const std::vector<EventPlace>& places, const NearestEvent& others, Take take) {
  for (const EventPlace& place : places) take(others.distance(place));
}

}  // namespace

void StreamDistance::add(const Events& a, const Events& b) {
  count(a, a_, 1), count(b, b_, -1);
  events_of_b_ += b.size();
  if (a.empty() || b.empty()) {
    alone_ += a.size() + b.size();
    return;
  }
  for (Means* means : {&scaled_, &gaussian_, &px_}) means->of_a += a.size(), means->of_b += b.size();
  const std::int64_t begin = std::min(a.front().t_ns, b.front().t_ns);
  const auto in_px_a = placesOf(a, begin), in_px_b = placesOf(b, begin);
  forEachDistance(in_px_a, NearestEvent(in_px_b), [&](double d) { px_.a += d; });
  forEachDistance(in_px_b, NearestEvent(in_px_a), [&](double d) { px_.b += d; });
  const auto scaled_a = scaled(in_px_a), scaled_b = scaled(in_px_b);
  const auto gauss = [](double d) { return -std::expm1(-d * d / 0.4); };
  forEachDistance(scaled_a, NearestEvent(scaled_b),
                  [&](double d) { scaled_.a += d, gaussian_.a += gauss(d); });
  forEachDistance(scaled_b, NearestEvent(scaled_a),
                  [&](double d) { scaled_.b += d, gaussian_.b += gauss(d); });
}

void StreamDistance::count(const Events& events, ImageF& balance, int sign) {
  for (const Event& e : events) {
    balance.at(e.x, e.y) += e.p ? 1 : -1;
    apart_.at(e.x, e.y) += static_cast<float>(sign);
    on_apart_.at(e.x, e.y) += static_cast<float>(sign * e.p);
  }
}

double StreamDistance::countError() const {
  double sum = 0;
  forEachPixel(apart_, [&](int x, int y) {
    const double on = on_apart_.at(x, y), off = apart_.at(x, y) - on_apart_.at(x, y);
    sum += std::abs(on) + std::abs(off);
  });
  if (events_of_b_ == 0) return sum == 0 ? 0 : std::numeric_limits<double>::infinity();
  return sum / static_cast<double>(events_of_b_);
}

}  // namespace saccade::eval
