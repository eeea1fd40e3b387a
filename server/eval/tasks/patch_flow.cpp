#include "eval/tasks/patch_flow.h"

#include <cmath>

#include "base/quantile.h"
#include "eval/tasks/nelder_mead.h"
#include "eval/tasks/windows.h"

namespace saccade::eval {
namespace {

constexpr double kStepPx = 2, kPrecisePx = 0.02;
constexpr int kMarginPx = kPatchPx / 2;  // around the patch, for events that leave it

// Row by row.
std::vector<Events> patchesOf(const Window& window, int across, int down) {
  std::vector<Events> patches(static_cast<std::size_t>(across) * static_cast<std::size_t>(down));
  for (const Event& e : window.events) {
    const int column = e.x / kPatchPx, row = e.y / kPatchPx;
    if (column < across && row < down)
      patches[static_cast<std::size_t>(row) * static_cast<std::size_t>(across) +
              static_cast<std::size_t>(column)]
          .push_back(e);
  }
  return patches;
}

Vec2 meanFlow(const Events& events, const TaskTruth& truth) {
  Vec2 mean;
  const float share = 1 / static_cast<float>(events.size());
  for (const Event& e : events) {
    const Vec2 flow = truth.flowAt({float(e.x), float(e.y)}, TimeNs(e.t_ns));
    mean.x += share * flow.x, mean.y += share * flow.y;
  }
  return mean;
}

}  // namespace

Vec2 patchFlow(std::span<const Event> events, int left, int top, TimeNs reference, double span_s) {
  WarpedEvents image(kPatchPx + 2 * kMarginPx, kPatchPx + 2 * kMarginPx);
  const auto contrast = [&](const Variables& px) {
    const auto warp = [&](const Event& e) {
      const double share = seconds(TimeNs(e.t_ns) - reference) / span_s;
      return Vec2{static_cast<float>(e.x - left + kMarginPx - px[0] * share),
                  static_cast<float>(e.y - top + kMarginPx - px[1] * share)};
    };
    return -contrastOf(events, warp, image);
  };
  const Variables px = minimise(contrast, {0, 0}, kStepPx, kPrecisePx);
  return {static_cast<float>(px[0] / span_s), static_cast<float>(px[1] / span_s)};
}

// The median over the patches of |v - v_true| / |v_true|, where v_true is the mean flow at its events.
TaskScore scorePatchFlow(const TaskInput& input) {
  const int across = input.truth.camera.width / kPatchPx, down = input.truth.camera.height / kPatchPx;
  std::vector<double> errors;
  for (const Window& window : windowsOf(input)) {
    const std::vector<Events> patches = patchesOf(window, across, down);
    for (std::size_t i = 0; i < patches.size(); ++i) {
      if (patches[i].size() < kLeastPatchEvents) continue;
      const Vec2 truth = meanFlow(patches[i], input.truth);
      if (!(std::hypot(truth.x, truth.y) > 0)) continue;
      const int left = static_cast<int>(i) % across * kPatchPx, top = static_cast<int>(i) / across * kPatchPx;
      const Vec2 flow = patchFlow(patches[i], left, top, window.middle(), window.span_s());
      errors.push_back(std::hypot(flow.x - truth.x, flow.y - truth.y) / std::hypot(truth.x, truth.y));
    }
  }
  if (errors.empty()) return {};
  return {quantile(errors, 0.5), errors.size()};
}

}  // namespace saccade::eval
