#include "eval/metrics/nearest_event.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <span>
#include <utility>

#include "base/check.h"

namespace saccade::eval {
namespace {

// Along which the places spread most.
std::uint8_t widestAxis(std::span<const EventPlace> places) {
  EventPlace low = places.front(), high = low;
  for (const EventPlace& place : places)
    for (std::size_t i = 0; i < place.size(); ++i) {
      low[i] = std::min(low[i], place[i]);
      high[i] = std::max(high[i], place[i]);
    }
  std::size_t widest = 0;
  for (std::size_t i = 1; i < low.size(); ++i)
    if (high[i] - low[i] > high[widest] - low[widest]) widest = i;
  return static_cast<std::uint8_t>(widest);
}

double squareOfDistance(const EventPlace& a, const EventPlace& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = static_cast<double>(a[i]) - static_cast<double>(b[i]);
    sum += d * d;
  }
  return sum;
}

}  // namespace

NearestEvent::NearestEvent(std::vector<EventPlace> places)
    : places_(std::move(places)), axes_(places_.size()) {
  SACCADE_CHECK(!places_.empty());
  build(0, places_.size());
}

void NearestEvent::build(std::size_t begin, std::size_t end) {
  if (end - begin < 2) return;
  const std::size_t middle = begin + (end - begin) / 2;
  const std::uint8_t axis = widestAxis(std::span(places_).subspan(begin, end - begin));
  const auto at = [&](std::size_t i) { return places_.begin() + static_cast<std::ptrdiff_t>(i); };
  std::nth_element(at(begin), at(middle), at(end),
                   [axis](const EventPlace& a, const EventPlace& b) { return a[axis] < b[axis]; });
  axes_[middle] = axis;
  build(begin, middle);
  build(middle + 1, end);
}

double NearestEvent::distance(const EventPlace& place) const {
  double nearest = std::numeric_limits<double>::infinity();
  search(0, places_.size(), place, nearest);
  return std::sqrt(nearest);
}

void NearestEvent::search(std::size_t begin, std::size_t end, const EventPlace& place,
                          double& nearest) const {
  if (begin == end) return;
  const std::size_t middle = begin + (end - begin) / 2;
  nearest = std::min(nearest, squareOfDistance(places_[middle], place));
  const std::uint8_t axis = axes_[middle];
  const double beyond = static_cast<double>(place[axis]) - static_cast<double>(places_[middle][axis]);
  const auto left = [&] { search(begin, middle, place, nearest); };
  const auto right = [&] { search(middle + 1, end, place, nearest); };
  beyond < 0 ? left() : right();
  if (beyond * beyond < nearest) beyond < 0 ? right() : left();
}

}  // namespace saccade::eval
