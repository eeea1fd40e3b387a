// The nearest of a set of events, in pixels and time.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace saccade::eval {

// A place in the space where distances are taken: x, y, time, polarity, each in units of distance.
using EventPlace = std::array<float, 4>;

// A k-d tree [Bentley 1975]. Takes O(n log n) once, and about O(log n) for each look-up.
class NearestEvent {
 public:
  explicit NearestEvent(std::vector<EventPlace> places);  // not empty, finite

  double distance(const EventPlace& place) const;  // to the nearest of them

 private:
  // Both of the places [begin, end): in the middle stands the median along one axis, between two halves.
  void build(std::size_t begin, std::size_t end);
  void search(std::size_t begin, std::size_t end, const EventPlace& place, double& nearest) const;

  std::vector<EventPlace> places_;
  std::vector<std::uint8_t> axes_;  // of the median at each place
};

}  // namespace saccade::eval
