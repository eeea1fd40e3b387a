#include "eval/tasks/rotation.h"

#include <cmath>

#include "eval/tasks/nelder_mead.h"
#include "eval/tasks/windows.h"
#include "scene/camera/pose.h"

namespace saccade::eval {
namespace {

constexpr double kStepPx = 2, kPrecisePx = 0.02;

// Where the surface of an event is seen once the camera has turned by -w times the event's distance in time.
class TurnBack {
 public:
  TurnBack(const CameraModel& camera, TimeNs reference, Vec3d w)
      : camera_(camera), reference_(reference), w_(w) {}

  Vec2 operator()(const Event& e) const {
    const double dt = seconds(TimeNs(e.t_ns) - reference_);
    const Vec3d seen{(e.x - camera_.cx) / camera_.fx, (e.y - camera_.cy) / camera_.fy, 1};
    const Vec3d d = rotate(axisAngle(w_ * dt), seen);
    if (!(d.z > 0)) return {-1, -1};  // behind the camera: outside the picture
    return {static_cast<float>(camera_.cx + camera_.fx * d.x / d.z),
            static_cast<float>(camera_.cy + camera_.fy * d.y / d.z)};
  }

 private:
  const CameraModel& camera_;
  TimeNs reference_;
  Vec3d w_;
};

}  // namespace

// The variables are pixels over the span at the middle of the picture, but for the roll.
Vec3d rotationOf(std::span<const Event> events, const CameraModel& camera, TimeNs reference, double span_s,
                 Vec3d start) {
  WarpedEvents image(camera.width, camera.height);
  const double px = camera.fx * span_s;
  const auto velocity = [&](const Variables& v) { return Vec3d{v[0], v[1], v[2]} / px; };
  const Variables best = minimise(
      [&](const Variables& v) {
        return -contrastOf(events, TurnBack(camera, reference, velocity(v)), image);
      },
      {start.x * px, start.y * px, start.z * px}, kStepPx, kPrecisePx);
  return velocity(best);
}

// The mean over the windows of |w - w_true| / |w_true|. The search of a window begins with the result before.
TaskScore scoreRotation(const TaskInput& input) {
  TaskScore score{0, 0};
  Vec3d w{};
  for (const Window& window : windowsOf(input)) {
    if (window.events.empty()) continue;
    w = rotationOf(window.events, input.truth.camera, window.middle(), window.span_s(), w);
    const Vec3d truth = input.truth.frameAt(window.middle()).camera.angular;
    score.error += length(w - truth) / length(truth);
    ++score.answers;
  }
  if (score.answers == 0) return {};
  score.error /= static_cast<double>(score.answers);
  return score;
}

}  // namespace saccade::eval
