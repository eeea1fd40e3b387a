#include "eval/tasks/efast.h"

#include <algorithm>
#include <array>
#include <limits>
#include <span>

namespace saccade::eval {
namespace {

struct Offset {
  int x, y;
};

// Counter-clockwise, as in the authors' program.
constexpr std::array<Offset, 16> kCircle3{{{0, 3},
                                           {1, 3},
                                           {2, 2},
                                           {3, 1},
                                           {3, 0},
                                           {3, -1},
                                           {2, -2},
                                           {1, -3},
                                           {0, -3},
                                           {-1, -3},
                                           {-2, -2},
                                           {-3, -1},
                                           {-3, 0},
                                           {-3, 1},
                                           {-2, 2},
                                           {-1, 3}}};
constexpr std::array<Offset, 20> kCircle4{{{0, 4},   {1, 4},  {2, 3},  {3, 2},  {4, 1},   {4, 0},   {4, -1},
                                           {3, -2},  {2, -3}, {1, -4}, {0, -4}, {-1, -4}, {-2, -3}, {-3, -2},
                                           {-4, -1}, {-4, 0}, {-4, 1}, {-3, 2}, {-2, 3},  {-1, 4}}};

// Whether an arc of `least` to `most` pixels is newer than the rest of the circle.
bool hasNewArc(const Image<double>& times, int x, int y, std::span<const Offset> circle, std::size_t least,
               std::size_t most) {
  const auto time = [&](std::size_t i) {
    const Offset& at = circle[i % circle.size()];
    return times.at(x + at.x, y + at.y);
  };
  for (std::size_t first = 0; first < circle.size(); ++first) {
    for (std::size_t size = least; size <= most; ++size) {
      double oldest = std::numeric_limits<double>::infinity(), newest_other = -oldest;
      for (std::size_t i = 0; i < circle.size(); ++i) {
        double& bound = i < size ? oldest : newest_other;
        bound = i < size ? std::min(bound, time(first + i)) : std::max(bound, time(first + i));
      }
      if (oldest > newest_other) return true;
    }
  }
  return false;
}

}  // namespace

bool isCorner(const Image<double>& times, int x, int y) {
  if (x < kCornerReach || y < kCornerReach || x >= times.width() - kCornerReach ||
      y >= times.height() - kCornerReach)
    return false;
  return hasNewArc(times, x, y, kCircle3, 3, 6) && hasNewArc(times, x, y, kCircle4, 4, 8);
}

}  // namespace saccade::eval
