#include "scene/camera/lens.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"

namespace saccade {
namespace {

constexpr double kMargin = 1;  // pixels around the picture that the lens shows too: pixels are shifted

Vec2 toFloat(PlanePoint p) {
  return {static_cast<float>(p.x), static_cast<float>(p.y)};
}

// The largest distance from the centre of the plane that the corners of a picture `times` as large show. It
// is infinity where one shows nothing.
double distanceShown(const CameraModel& camera, double times) {
  double largest = 0;
  for (const double x : {-kMargin, camera.width - 1 + kMargin}) {
    for (const double y : {-kMargin, camera.height - 1 + kMargin}) {
      const auto p = undistortFromCentre(
          camera.distortion, {times * (x - camera.cx) / camera.fx, times * (y - camera.cy) / camera.fy});
      if (!p) return std::numeric_limits<double>::infinity();
      largest = std::max(largest, std::hypot(p->x, p->y));
    }
  }
  return largest;
}

// Of the largest picture with the same lens, up to twice as large.
double reachOf(const CameraModel& camera) {
  for (const double times : {2.0, 1.5, 1.2}) {
    if (const double reach = distanceShown(camera, times); std::isfinite(reach)) return reach;
  }
  return distanceShown(camera, 1);
}

}  // namespace

// Lines from the principal point to the edges cover the picture. The lens must not fold along any.
std::string lensFault(const CameraModel& camera) {
  if (camera.distortion.isNone()) return {};
  constexpr int kParts = 64;  // of an edge
  const double right = camera.width - 1 + kMargin, bottom = camera.height - 1 + kMargin;
  const auto shows = [&](double x, double y) {
    const PlanePoint shown{(x - camera.cx) / camera.fx, (y - camera.cy) / camera.fy};
    return undistortFromCentre(camera.distortion, shown).has_value();
  };
  for (int i = 0; i <= kParts; ++i) {
    const double x = -kMargin + (right + kMargin) * i / kParts,
                 y = -kMargin + (bottom + kMargin) * i / kParts;
    if (!shows(x, -kMargin) || !shows(x, bottom) || !shows(-kMargin, y) || !shows(right, y))
      return "the lens does not reach all of the picture: it folds back, or it would have to see more than " +
             std::to_string(static_cast<int>(kMaxLensAngleDeg)) + " degrees from the viewing axis";
  }
  return {};
}

Lens::Lens(const CameraModel& camera)
    : camera_(camera), reach_(isDistorted() ? reachOf(camera) : std::numeric_limits<double>::infinity()) {
  SACCADE_CHECK(!isDistorted() || std::isfinite(reach_));
}

void Lens::tabulate() {
  if (!isDistorted() || !table_.empty()) return;
  table_.reserve(static_cast<std::size_t>(camera_.width) * static_cast<std::size_t>(camera_.height));
  for (int y = 0; y < camera_.height; ++y) {
    std::optional<PlanePoint> near;  // of the pixel before
    for (int x = 0; x < camera_.width; ++x) {
      const PlanePoint shown = shownAt(x, y);
      if (near) near = undistort(camera_.distortion, shown, *near);
      if (!near) near = undistortFromCentre(camera_.distortion, shown);
      SACCADE_CHECK(near);
      table_.push_back(toFloat(*near));
    }
  }
}

Vec2 Lens::planePoint(float x, float y) const {
  const PlanePoint shown = shownAt(x, y);
  if (!isDistorted()) return toFloat(shown);
  if (table_.empty()) return toFloat(undistortFromCentre(camera_.distortion, shown).value_or(PlanePoint{}));
  const float column = std::clamp(std::round(x), 0.f, static_cast<float>(camera_.width - 1));
  const float row = std::clamp(std::round(y), 0.f, static_cast<float>(camera_.height - 1));
  const Vec2 near = table_[static_cast<std::size_t>(row) * static_cast<std::size_t>(camera_.width) +
                           static_cast<std::size_t>(column)];
  if (x == column && y == row) return near;
  const auto p = undistort(camera_.distortion, shown, {near.x, near.y});
  return p ? toFloat(*p) : near;
}

PlanePoint Lens::pixelOf(PlanePoint p) const {
  const double beyond = std::max(1.0, std::hypot(p.x, p.y) / reach_);
  const PlanePoint shown = distort(camera_.distortion, {p.x / beyond, p.y / beyond});
  return {camera_.fx * shown.x * beyond + camera_.cx, camera_.fy * shown.y * beyond + camera_.cy};
}

PlaneMap Lens::pixelSlope(PlanePoint p) const {
  const PlaneMap slope = distortionSlope(camera_.distortion, p);
  return {camera_.fx * slope.xx, camera_.fx * slope.xy, camera_.fy * slope.yx, camera_.fy * slope.yy};
}

}  // namespace saccade
