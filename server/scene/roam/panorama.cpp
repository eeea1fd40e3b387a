#include "scene/roam/panorama.h"

#include <algorithm>
#include <cmath>

namespace saccade {
namespace {

constexpr int kMargin = 1;  // rows beyond those that a view may have as its middle
constexpr int kRows = Panorama::kTilts + 2 * kMargin;
constexpr double kMostRelief = 0.5;  // of a direction

// The surfaces in each direction, row by row from the lowest.
class Surroundings {
 public:
  Surroundings(const FreeSpace& space, Vec3d place, const Level& level, const SeenRange& range)
      : range_(range), distances_(static_cast<std::size_t>(kRows * Panorama::kPans)) {
    for (int row = 0; row < kRows; ++row)
      for (int pan = 0; pan < Panorama::kPans; ++pan)
        directions_.push_back(level.direction(Panorama::panOf(pan), Panorama::tiltOf(row - kMargin)));
    space.look(place, directions_, distances_);
  }

  bool isSeen(int pan, int row) const { return range_.has(distances_[index(pan, row)]); }

  // How far the point that is met lies beside the lines between its neighbours, as a share of its distance. A
  // plane has none.
  double relief(int pan, int row) const {
    const double sum = beside(pan, row, 1, 0) + beside(pan, row, 0, 1);
    return std::min(kMostRelief, sum / length(point(pan, row)));
  }

 private:
  static std::size_t index(int pan, int row) {
    const int around = (pan + Panorama::kPans) % Panorama::kPans;
    return static_cast<std::size_t>(std::clamp(row, 0, kRows - 1) * Panorama::kPans + around);
  }
  Vec3d point(int pan, int row) const {
    const std::size_t i = index(pan, row);
    return directions_[i] * std::clamp(distances_[i], range_.nearest, range_.farthest);
  }
  double beside(int pan, int row, int right, int up) const {
    if (up != 0 && (row == 0 || row == kRows - 1)) return 0;
    const Vec3d a = point(pan - right, row - up), b = point(pan + right, row + up);
    return length(cross(point(pan, row) - a, b - a)) / std::max(length(b - a), range_.nearest);
  }

  SeenRange range_;
  std::vector<Vec3d> directions_;
  std::vector<double> distances_;
};

// Half the angle between two points at the edges of the picture, in steps. It is at least one, so that a
// narrow view keeps away from edges.
int halfSteps(Vec2 a, Vec2 b) {
  const double angle = std::atan(std::hypot(a.x - b.x, a.y - b.y) / 2);
  return std::clamp(static_cast<int>(angle / Panorama::kStep), 1, Panorama::kPans / 2 - 1);
}

}  // namespace

Panorama::Panorama(const FreeSpace& space, Vec3d place, const Level& level, const Lens& lens,
                   const SeenRange& range) {
  const Surroundings around(space, place, level, range);
  std::vector<View> cells;
  for (int row = 0; row < kRows; ++row)
    for (int pan = 0; pan < kPans; ++pan)
      cells.push_back({around.isSeen(pan, row) ? 1.0 : 0.0, around.relief(pan, row)});
  const CameraModel& c = lens.camera();
  const auto right = static_cast<float>(c.width - 1), bottom = static_cast<float>(c.height - 1);
  const int wide = halfSteps(lens.planePoint(0, bottom / 2), lens.planePoint(right, bottom / 2));
  const int high = halfSteps(lens.planePoint(right / 2, 0), lens.planePoint(right / 2, bottom));
  for (int tilt = 0; tilt < kTilts; ++tilt) {
    const int lowest = std::max(0, tilt + kMargin - high),
              highest = std::min(kRows - 1, tilt + kMargin + high);
    for (int pan = 0; pan < kPans; ++pan) {
      View sum{0, 0};
      for (int row = lowest; row <= highest; ++row)
        for (int column = pan - wide; column <= pan + wide; ++column) {
          const View& cell = cells[static_cast<std::size_t>(row * kPans + (column + kPans) % kPans)];
          sum.share += cell.share, sum.relief += cell.relief;
        }
      const int count = (highest - lowest + 1) * (2 * wide + 1);
      views_.push_back({sum.share / count, sum.relief / count});
    }
  }
}

double Panorama::bestShare() const {
  return std::ranges::max_element(views_, {}, &View::share)->share;
}

}  // namespace saccade
