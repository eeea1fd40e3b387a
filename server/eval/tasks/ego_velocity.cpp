#include "eval/tasks/ego_velocity.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "eval/bench/interrupt.h"
#include "eval/tasks/active_events.h"
#include "eval/tasks/normal_flow.h"
#include "eval/tasks/windows.h"

namespace saccade::eval {
namespace {

// One equation: row . v = value.
struct Equation {
  Vec3d row;
  double value;
};

Equation equationOf(const EdgeFlow& edge, const CameraModel& camera, Vec3d w) {
  const double x = (edge.position.x - camera.cx) / camera.fx, y = (edge.position.y - camera.cy) / camera.fy;
  const double speed = std::hypot(edge.flow.x, edge.flow.y);
  const double nx = camera.fx * edge.flow.x / speed, ny = camera.fy * edge.flow.y / speed;
  const double turn_x = x * y * w.x - (1 + x * x) * w.y + y * w.z;
  const double turn_y = (1 + y * y) * w.x - x * y * w.y - x * w.z;
  return {Vec3d{-nx, -ny, nx * x + ny * y} / double(edge.depth), speed - nx * turn_x - ny * turn_y};
}

// Least squares with these weights: the normal equations, by Cramer's rule.
std::optional<Vec3d> solve(const std::vector<Equation>& equations, const std::vector<double>& weights) {
  Vec3d a{}, b{}, c{}, right{};  // columns of the matrix, and the right side
  for (std::size_t i = 0; i < equations.size(); ++i) {
    const auto& [row, value] = equations[i];
    const Vec3d weighted = row * weights[i];
    a = a + weighted * row.x, b = b + weighted * row.y, c = c + weighted * row.z;
    right = right + weighted * value;
  }
  constexpr double kSingular = 1e-6;  // volume of the columns, over that of a box of their lengths
  const double volume = dot(a, cross(b, c));
  if (!(volume > kSingular * length(a) * length(b) * length(c))) return {};
  return Vec3d{dot(right, cross(b, c)), dot(a, cross(right, c)), dot(a, cross(b, right))} / volume;
}

// The edges of a window, of the events that `active` keeps.
std::vector<EdgeFlow> edgesOf(const Window& window, const TaskTruth& truth, ActiveEvents& active) {
  std::vector<EdgeFlow> edges;
  for (const Event& e : window.events) {
    if (!active.add(e)) continue;
    const Vec2 position{float(e.x), float(e.y)};
    const auto flow = normalFlow(active.times(e.p), e.x, e.y);
    if (flow) edges.push_back({position, *flow, truth.depthAt(position, TimeNs(e.t_ns))});
  }
  return edges;
}

}  // namespace

// The least sum of absolute errors is that of least squares with weights 1 / |error|, found in turns.
std::optional<Vec3d> egoVelocity(std::span<const EdgeFlow> edges, const CameraModel& camera, Vec3d angular) {
  constexpr int kTurns = 30;
  constexpr double kLeastError = 1e-3;  // pixels per second; keeps weights finite
  if (edges.size() < kLeastEdges) return {};
  std::vector<Equation> equations;
  for (const EdgeFlow& edge : edges) equations.push_back(equationOf(edge, camera, angular));
  std::vector<double> weights(equations.size(), 1);
  std::optional<Vec3d> v = solve(equations, weights);
  for (int turn = 0; turn < kTurns && v; ++turn) {
    std::transform(equations.begin(), equations.end(), weights.begin(), [&](const Equation& e) {
      return 1 / std::max(std::abs(dot(e.row, *v) - e.value), kLeastError);
    });
    v = solve(equations, weights);
  }
  return v;
}

// The mean over the windows of |v - v_true| / |v_true|.
TaskScore scoreEgoVelocity(const TaskInput& input) {
  ActiveEvents active(input.truth.camera.width, input.truth.camera.height);
  TaskScore score{0, 0};
  for (const Window& window : windowsOf(input)) {
    if (interrupted()) throw Interrupted{};
    const Velocity truth = input.truth.frameAt(window.middle()).camera;
    const auto v = egoVelocity(edgesOf(window, input.truth, active), input.truth.camera, truth.angular);
    if (!v) continue;
    score.error += length(*v - truth.linear) / length(truth.linear);
    ++score.answers;
  }
  if (score.answers == 0) return {};
  score.error /= static_cast<double>(score.answers);
  return score;
}

}  // namespace saccade::eval
