#include "eval/tasks/normal_flow.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/quantile.h"
#include "eval/bench/interrupt.h"
#include "eval/tasks/active_events.h"
#include "eval/tasks/task.h"

namespace saccade::eval {
namespace {

struct PlanePoint3 {
  double x, y, t;  // pixels and seconds from the event
};

struct TimePlane {
  double t0, a, b;
  double residual(const PlanePoint3& p) const { return p.t - t0 - a * p.x - b * p.y; }
  double slope() const { return std::hypot(a, b); }
};

constexpr std::size_t kPlanePixels = (2 * kPlaneRadius + 1) * (2 * kPlaneRadius + 1);

// Up to kPlanePixels points.
struct PlanePoints {
  std::array<PlanePoint3, kPlanePixels> all;
  std::size_t count = 0;
  auto begin() const { return all.begin(); }
  auto end() const { return all.begin() + static_cast<std::ptrdiff_t>(count); }
};

PlanePoints pointsAround(const Image<double>& times, int x, int y) {
  PlanePoints points;
  const double now = times.at(x, y);
  for (int dy = -kPlaneRadius; dy <= kPlaneRadius; ++dy) {
    for (int dx = -kPlaneRadius; dx <= kPlaneRadius; ++dx) {
      const double t = times.at(x + dx, y + dy) - now;
      if (t >= -kPlaneSpanS) points.all[points.count++] = {double(dx), double(dy), t};
    }
  }
  return points;
}

// Least squares: the normal equations about the mean of the points.
std::optional<TimePlane> fitPlane(const PlanePoints& points) {
  const auto n = static_cast<double>(points.count);
  double x = 0, y = 0, t = 0, xx = 0, xy = 0, yy = 0, xt = 0, yt = 0;
  for (const PlanePoint3& p : points) x += p.x / n, y += p.y / n, t += p.t / n;
  for (const PlanePoint3& p : points) {
    const double dx = p.x - x, dy = p.y - y, dt = p.t - t;
    xx += dx * dx, xy += dx * dy, yy += dy * dy, xt += dx * dt, yt += dy * dt;
  }
  const double det = xx * yy - xy * xy;
  if (!(det > 1e-9)) return {};  // on a line
  const double a = (xt * yy - yt * xy) / det, b = (yt * xx - xt * xy) / det;
  return TimePlane{t - a * x - b * y, a, b};
}

// Returns whether it removed a point.
bool rejectFar(const TimePlane& plane, PlanePoints& points) {
  const auto last = std::remove_if(
      points.all.begin(), points.all.begin() + static_cast<std::ptrdiff_t>(points.count),
      [&](const PlanePoint3& p) { return std::abs(plane.residual(p)) > kPlaneRejectPx * plane.slope(); });
  const auto left = static_cast<std::size_t>(last - points.all.begin());
  return std::exchange(points.count, left) != left;
}

}  // namespace

std::optional<Vec2> normalFlow(const Image<double>& times, int x, int y) {
  PlanePoints points = pointsAround(times, x, y);
  while (points.count >= kPlaneLeast) {
    const auto plane = fitPlane(points);
    if (!plane || !(plane->slope() > 0)) return {};
    if (rejectFar(*plane, points)) continue;
    const double scale = 1 / (plane->slope() * plane->slope());
    return Vec2{static_cast<float>(plane->a * scale), static_cast<float>(plane->b * scale)};
  }
  return {};
}

// The error of the speed against the true flow across the same edge, over the true flow.
TaskScore scoreNormalFlow(const TaskInput& input) {
  ActiveEvents active(input.truth.camera.width, input.truth.camera.height);
  std::vector<double> errors;
  for (const Event& e : input.events) {
    if (interrupted()) throw Interrupted{};
    if (!active.add(e)) continue;
    const auto flow = normalFlow(active.times(e.p), e.x, e.y);
    const Vec2 truth = input.truth.flowAt({float(e.x), float(e.y)}, TimeNs(e.t_ns));
    const double true_speed = std::hypot(truth.x, truth.y);
    if (!flow || !(true_speed > 0)) continue;
    const double speed = std::hypot(flow->x, flow->y);
    const double true_across = (flow->x * truth.x + flow->y * truth.y) / speed;
    errors.push_back(std::abs(speed - true_across) / true_speed);
  }
  if (errors.empty()) return {};
  return {quantile(errors, 0.5), errors.size()};
}

}  // namespace saccade::eval
