#include "feed/view_motion.h"

#include <algorithm>
#include <cmath>

#include "base/quantile.h"

namespace saccade {
namespace {

constexpr int kColumns = 32, kRows = 24;
constexpr double kMostOfThem = 0.99;

int centre(int cell, int cells, int size) {
  return (2 * cell + 1) * size / (2 * cells);
}

}  // namespace

void ViewMotion::look(const Frame& frame, const Camera& camera, const PosedScene& scene) {
  if (scene.bodies()) motions_.assign(scene.bodies()->motions().begin(), scene.bodies()->motions().end());
  if (scene.bodies() && !shadows_)
    shadows_.emplace(scene.still().description(), frame.width(), frame.height(), kColumns * kRows / 4);
  bodies_rest_ = true;
  points_.clear(), coarse_.clear();
  for (int row = 0; row < kRows; ++row) {
    for (int column = 0; column < kColumns; ++column) {
      const int x = centre(column, kColumns, frame.width()), y = centre(row, kRows, frame.height());
      const GBuffer& g = frame.g;
      if (g.z.at(x, y) >= kMissDepth) continue;
      const Vec3 direction = camera.direction(static_cast<float>(x), static_cast<float>(y));
      const Vec3 point = camera.origin + direction * g.z.at(x, y),
                 n{g.nx.at(x, y), g.ny.at(x, y), g.nz.at(x, y)};
      const std::uint32_t body = g.hasBodies() ? g.body.at(x, y) : 0;
      points_.push_back(
          {BodyPoint::of(point, body, motions_), body > 0 ? motions_[body - 1].restDirection(n) : n, {}});
      points_.back().at = camera.project(points_.back().point.at(motions_));
      if (row % 2 == 0 && column % 2 == 0) coarse_.push_back(points_.back());
    }
  }
  lengths_.reserve(kColumns * kRows);
}

double ViewMotion::moveTo(TimeNs t, const Camera& camera, const PosedScene& scene) {
  place(t, scene);
  lengths_.clear();
  for (ViewedPoint& point : points_) {
    const Camera::Projection before = point.at;
    point.at = camera.project(point.point.at(motions_));
    if (before.z > 0 && point.at.z > 0)
      lengths_.push_back(std::hypot(point.at.x - before.x, point.at.y - before.y));
  }
  const double surfaces = lengths_.empty() ? 0 : quantile(lengths_, kMostOfThem);
  return bodies_rest_ ? surfaces : std::max(surfaces, shadowsMove(camera));
}

// `scene` is still as look() has seen it: shadows are found once a body leaves its place.
void ViewMotion::place(TimeNs t, const PosedScene& scene) {
  const Scene& description = scene.still().description();
  for (std::size_t i = 0; i < motions_.size(); ++i)
    motions_[i] = motionOf(description.bodies[i], scene.still().inScene(scene.bodies()->paths()[i].at(t)));
  if (!bodies_rest_ || !scene.bodies() || std::ranges::equal(motions_, scene.bodies()->motions())) return;
  bodies_rest_ = false;
  shadows_->look(coarse_, scene);
}

// Few shadows count as few surfaces do: as a share of all points.
double ViewMotion::shadowsMove(const Camera& camera) {
  lengths_.clear();
  shadows_->appendSteps(camera, motions_, lengths_);
  lengths_.resize(std::max(lengths_.size(), coarse_.size()));
  return lengths_.empty() ? 0 : quantile(lengths_, kMostOfThem);
}

}  // namespace saccade
