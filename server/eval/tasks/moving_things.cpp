#include "eval/tasks/moving_things.h"

#include <algorithm>
#include <cmath>

#include "eval/tasks/area_under_roc.h"
#include "eval/tasks/nelder_mead.h"
#include "eval/tasks/windows.h"

namespace saccade::eval {
namespace {

constexpr double kStepPx = 2, kPrecisePx = 0.02;
constexpr std::size_t kObjectFrames = 16;  // of a window: slow objects need time to stand out

class Compensation {
 public:
  Compensation(const GlobalMotion& motion, int width, int height, TimeNs reference)
      : motion_(motion), cx_((width - 1) / 2.0), cy_((height - 1) / 2.0), reference_(reference) {}

  Vec2 operator()(const Event& e) const {
    const double dt = seconds(TimeNs(e.t_ns) - reference_), x = e.x - cx_, y = e.y - cy_;
    return {static_cast<float>(e.x - dt * (motion_.x + motion_.expansion * x - motion_.turn * y)),
            static_cast<float>(e.y - dt * (motion_.y + motion_.turn * x + motion_.expansion * y))};
  }
  // By how much it stretches areas at the time of an event.
  float area(const Event& e) const {
    const double dt = seconds(TimeNs(e.t_ns) - reference_), grow = 1 - dt * motion_.expansion;
    const double turn = dt * motion_.turn;
    return static_cast<float>(grow * grow + turn * turn);
  }

 private:
  GlobalMotion motion_;
  double cx_, cy_;  // the middle of the picture
  TimeNs reference_;
};

}  // namespace

// The variables are pixels over the span: those of expansion and turn at a quarter of the width from the
// middle.
GlobalMotion globalMotion(std::span<const Event> events, int width, int height, TimeNs reference,
                          double span_s) {
  WarpedEvents image(width, height);
  const double arm = span_s * width / 4;
  const auto motion = [&](const Variables& v) {
    return GlobalMotion{v[0] / span_s, v[1] / span_s, v[2] / arm, v[3] / arm};
  };
  const auto contrast = [&](const Variables& v) {
    const Compensation warp(motion(v), width, height, reference);
    return -contrastOf(events, warp, image, [&](const Event& e) { return warp.area(e); });
  };
  return motion(minimise(contrast, {0, 0, 0, 0}, kStepPx, kPrecisePx, 400));
}

std::vector<double> motionScores(std::span<const Event> events, int width, int height,
                                 const GlobalMotion& motion, TimeNs reference, double span_s) {
  const Compensation warp(motion, width, height, reference);
  WarpedEvents count(width, height), time(width, height);
  double mean = 0;
  for (const Event& e : events) {
    const double share = seconds(TimeNs(e.t_ns) - reference) / span_s;
    count.add(warp(e)), time.add(warp(e), static_cast<float>(share));
    mean += share / static_cast<double>(events.size());
  }
  count.blur(), time.blur();
  std::vector<double> scores;
  for (const Event& e : events) {
    const double n = count.at(warp(e));
    scores.push_back(std::abs(time.at(warp(e)) - n * mean) / (n + kPriorEvents));
  }
  return scores;
}

// 1 - the area under ROC over the events of all windows; positive are those where a body is shown.
TaskScore scoreMovingObjects(const TaskInput& input) {
  const int width = input.truth.camera.width, height = input.truth.camera.height;
  std::vector<Scored> all;
  for (const Window& window : windowsOf(input, kObjectFrames)) {
    const GlobalMotion motion = globalMotion(window.events, width, height, window.middle(), window.span_s());
    const std::vector<double> scores =
        motionScores(window.events, width, height, motion, window.middle(), window.span_s());
    for (std::size_t i = 0; i < scores.size(); ++i) {
      const Event& e = window.events[i];
      all.push_back({scores[i], input.truth.frameAt(TimeNs(e.t_ns)).body.at(e.x, e.y) != 0});
    }
  }
  return {1 - areaUnderRoc(all), all.size()};
}

}  // namespace saccade::eval
