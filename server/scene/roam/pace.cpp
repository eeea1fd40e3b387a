#include "scene/roam/pace.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/quantile.h"
#include "scene/camera/image_speed.h"

namespace saccade {
namespace {

constexpr int kColumns = 8, kRows = 6;  // of the rays through the picture
constexpr double kStep = 1e-3;          // of the course, between the poses that give its velocity
constexpr int kSmoothings = 4;          // each is over three places
constexpr double kLeastRate = 0.3;      // of the mean

// Directions through the picture, in the axes of the camera.
std::vector<Vec3d> raysOf(const Lens& lens) {
  const CameraModel& c = lens.camera();
  std::vector<Vec3d> rays;
  for (int row = 0; row < kRows; ++row)
    for (int column = 0; column < kColumns; ++column) {
      const auto centre = [](int i, int count, int size) {
        return (static_cast<float>(i) + 0.5f) * static_cast<float>(size) / static_cast<float>(count) - 0.5f;
      };
      const Vec2 p = lens.planePoint(centre(column, kColumns, c.width), centre(row, kRows, c.height));
      rays.push_back(normalize(Vec3d{p.x, p.y, 1}));
    }
  return rays;
}

// The motion of the camera while u grows by 1.
Twist twistAt(const Course& course, const Pose& pose, double u) {
  const Pose before = course.at(u), after = course.at(u + kStep);
  return {rotate(conjugate(pose.rotation), after.position - before.position) / kStep,
          rotationVector(conjugate(before.rotation) * after.rotation) / kStep};
}

struct Look {
  double seen, turn;           // the share; radians while u grows by 1
  std::vector<double> speeds;  // of the images of what is met, in focal lengths while u grows by 1
};

class Looker {
 public:
  Looker(const FreeSpace& space, const Lens& lens, const SeenRange& range)
      : space_(space), lens_(lens), range_(range), rays_(raysOf(lens)), distances_(rays_.size()) {}

  Look at(const Course& course, double u) {
    const Pose pose = course.at(u);
    std::vector<Vec3d> directions;
    for (const Vec3d ray : rays_) directions.push_back(rotate(pose.rotation, ray));
    space_.look(pose.position, directions, distances_);
    const Twist twist = twistAt(course, pose, u);
    double seen = 0;
    VisiblePoints view;
    for (std::size_t i = 0; i < rays_.size(); ++i) {
      seen += range_.has(distances_[i]);
      if (std::isfinite(distances_[i])) view.push_back(rays_[i] * distances_[i]);
    }
    return {seen / static_cast<double>(rays_.size()), length(twist.angular), imageSpeeds(view, twist, lens_)};
  }

 private:
  const FreeSpace& space_;
  const Lens& lens_;
  SeenRange range_;
  std::vector<Vec3d> rays_;
  std::vector<double> distances_;
};

// Of the places and their two neighbours, again and again.
void smooth(std::vector<double>& rates) {
  const std::size_t n = rates.size();
  for (int round = 0; round < kSmoothings; ++round) {
    const std::vector<double> was = rates;
    for (std::size_t i = 0; i < n; ++i) rates[i] = (was[(i + n - 1) % n] + 2 * was[i] + was[(i + 1) % n]) / 4;
  }
}

// How fast the image moves at each place, while u grows by 1, smoothed and bounded.
std::vector<double> ratesOf(std::vector<Look>& looks) {
  std::vector<double> rates;
  for (Look& look : looks) rates.push_back(look.speeds.empty() ? 0 : quantile(look.speeds, 0.5));
  const double mean = std::accumulate(rates.begin(), rates.end(), 0.0) / static_cast<double>(rates.size());
  for (double& rate : rates) rate = std::max(rate, kLeastRate * mean);
  smooth(rates);
  for (std::size_t i = 0; i < rates.size(); ++i) rates[i] = std::max(rates[i], looks[i].turn / kMostTurn);
  return rates;
}

// The median speed of all images where a place counts as long as the camera needs for it.
double medianSpeed(const std::vector<Look>& looks, const std::vector<double>& rates) {
  struct Speed {
    double speed, time;
  };
  std::vector<Speed> speeds;
  double time = 0;
  for (std::size_t i = 0; i < looks.size(); ++i)
    for (const double speed : looks[i].speeds)
      speeds.push_back({speed / rates[i], rates[i]}), time += rates[i];
  std::ranges::sort(speeds, {}, &Speed::speed);
  double passed = 0;
  for (const Speed& s : speeds)
    if ((passed += s.time) >= time / 2) return s.speed;
  return 0;
}

}  // namespace

Pace measurePace(const FreeSpace& space, const Course& course, const Lens& lens, const SeenRange& range) {
  Looker looker(space, lens, range);
  std::vector<Look> looks;
  Pace pace;
  for (std::size_t i = 0; i < Pace::kLooks; ++i) {
    looks.push_back(looker.at(course, static_cast<double>(i) / Pace::kLooks));
    pace.seen.push_back(looks.back().seen);
  }
  const std::vector<double> rates = ratesOf(looks);
  const double median = medianSpeed(looks, rates);
  for (std::size_t i = 0; i < Pace::kLooks; ++i)
    pace.durations.push_back((rates[i] + rates[(i + 1) % Pace::kLooks]) / 2 * median / Pace::kLooks);
  return pace;
}

std::vector<Pose> evenlyInTime(const Course& course, const Pace& pace, std::size_t poses) {
  const double whole = std::accumulate(pace.durations.begin(), pace.durations.end(), 0.0);
  std::vector<Pose> even;
  std::size_t part = 0;
  double before = 0;
  for (std::size_t i = 0; i < poses; ++i) {
    const double time = whole * static_cast<double>(i) / static_cast<double>(poses);
    while (part + 1 < Pace::kLooks && time >= before + pace.durations[part]) before += pace.durations[part++];
    const double share = (time - before) / pace.durations[part];
    even.push_back(course.at((static_cast<double>(part) + share) / Pace::kLooks));
  }
  return even;
}

}  // namespace saccade
