#include "feed/moving_view.h"

#include <cmath>
#include <limits>

namespace saccade {
namespace {

constexpr int kColumns = 32, kRows = 24;

std::shared_ptr<const RenderScene> borrowed(const RenderScene& scene) {
  return {std::shared_ptr<const void>(), &scene};
}

}  // namespace

MovingView::MovingView(const RenderScene& scene, const std::vector<Trajectory>& paths)
    : now_(borrowed(scene), paths), before_(borrowed(scene), paths) {}

// The camera that stands gives exactly 0, because both projections use the same formula.
void MovingView::appendSteps(const At& now, const At& before, const CameraModel& camera,
                             std::vector<double>& lengths) {
  now_.setTime(now.time), before_.setTime(before.time);
  const auto centre = [](int i, int count, int size) {
    return (static_cast<float>(i) + 0.5f) * static_cast<float>(size) / static_cast<float>(count) - 0.5f;
  };
  for (int cell = 0; cell < kColumns * kRows; ++cell) {
    const Vec3 direction = now.camera.direction(centre(cell % kColumns, kColumns, camera.width),
                                                centre(cell / kColumns, kRows, camera.height));
    const Hit hit =
        now_.geometry().intersect({now.camera.origin, direction, std::numeric_limits<float>::infinity()});
    if (!hit.valid) continue;
    const Vec3 point = now.camera.origin + direction * hit.t;
    const auto to = now.camera.project(point),
               from = before.camera.project(now_.carried(hit, point, before_));
    if (from.z > 0) lengths.push_back(std::hypot(to.x - from.x, to.y - from.y) * now.camera.pixel);
  }
}

}  // namespace saccade
