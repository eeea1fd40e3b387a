#include "feed/view_motion.h"

#include <cmath>

#include "base/quantile.h"

namespace saccade {
namespace {

constexpr int kColumns = 32, kRows = 24;

int centre(int cell, int cells, int size) {
  return (2 * cell + 1) * size / (2 * cells);
}

}  // namespace

void ViewMotion::look(const Frame& frame, const Camera& camera, const PosedScene& scene) {
  if (scene.bodies()) motions_.assign(scene.bodies()->motions().begin(), scene.bodies()->motions().end());
  points_.clear();
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const int x = centre(column, kColumns, frame.width()), y = centre(row, kRows, frame.height());
      const float z = frame.g.z.at(x, y);
      if (z >= kMissDepth) continue;
      const Vec3 point = camera.origin + camera.direction(static_cast<float>(x), static_cast<float>(y)) * z;
      const std::uint32_t body = frame.g.hasBodies() ? frame.g.body.at(x, y) : 0;
      points_.push_back({body, body > 0 ? motions_[body - 1].restPoint(point) : point, {}});
      points_.back().at = project(points_.back(), camera);
    }
  }
  lengths_.reserve(kColumns * kRows);
}

double ViewMotion::moveTo(TimeNs t, const Camera& camera, const PosedScene& scene) {
  const Scene& description = scene.still().description();
  for (std::size_t i = 0; i < motions_.size(); ++i)
    motions_[i] = motionOf(description.bodies[i], scene.still().inScene(scene.bodies()->paths()[i].at(t)));
  lengths_.clear();
  for (Point& point : points_) {
    const Camera::Projection before = point.at;
    point.at = project(point, camera);
    if (before.z > 0 && point.at.z > 0)
      lengths_.push_back(std::hypot(point.at.x - before.x, point.at.y - before.y));
  }
  return lengths_.empty() ? 0 : quantile(lengths_, 0.99);
}

Camera::Projection ViewMotion::project(const Point& point, const Camera& camera) const {
  return camera.project(point.body > 0 ? motions_[point.body - 1].point(point.rest) : point.rest);
}

}  // namespace saccade
