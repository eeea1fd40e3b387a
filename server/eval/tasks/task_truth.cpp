#include "eval/tasks/task_truth.h"

#include <algorithm>
#include <cmath>

#include "base/log_ratio.h"
#include "eval/bench/interrupt.h"
#include "eval/metrics/for_each_pixel.h"
#include "frame/pixel_before.h"

namespace saccade::eval {
namespace {

ImageF copyOf(const ImageF& image) {
  ImageF copy(image.width(), image.height());
  copy.copyFrom(image);
  return copy;
}

// GBuffer::motion goes back in time by an interval.
ImageF flowOf(const ImageF& motion, double interval_s) {
  ImageF flow(motion.width(), motion.height());
  const auto rate = static_cast<float>(-1 / interval_s);
  forEachPixel(motion, [&](int x, int y) { flow.at(x, y) = rate * motion.at(x, y); });
  return flow;
}

Image<std::uint32_t> bodiesOf(const GBuffer& cur, const GBuffer& prev) {
  Image<std::uint32_t> body(cur.z.width(), cur.z.height());
  if (!cur.hasBodies()) return body;
  forEachPixel(body,
               [&](int x, int y) { body.at(x, y) = cur.body.at(x, y) != 0 || prev.body.at(x, y) != 0; });
  return body;
}

// Both parts in the camera's axes.
Velocity cameraAt(const Trajectory& path, TimeNs t) {
  const Velocity v = path.velocityAt(t);
  return {rotate(inverse(path.at(t)).rotation, v.linear), v.angular};
}

TruthFrame frameOf(const Feed& feed, const IntensityChange& truth, double bias) {
  const RenderedInterval interval = *feed.interval().rendered;
  const GBuffer &cur = interval.frames.cur.g, &prev = interval.frames.prev.g;
  const double interval_s = seconds(truth.t1 - truth.t0);
  return {truth.t0,
          truth.t1,
          copyOf(cur.z),
          flowOf(cur.motion_x, interval_s),
          flowOf(cur.motion_y, interval_s),
          bodiesOf(cur, prev),
          logPicture(truth.I_now, bias),
          cameraAt(interval.path, (truth.t0 + truth.t1) / 2)};
}

// The pixel of the least depth within a pixel of a position.
PixelPlace nearestAround(const ImageF& z, Vec2 position) {
  const int x = std::clamp(static_cast<int>(std::lround(position.x)), 0, z.width() - 1);
  const int y = std::clamp(static_cast<int>(std::lround(position.y)), 0, z.height() - 1);
  PixelPlace nearest{x, y};
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, z.height() - 1); ++v) {
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, z.width() - 1); ++u)
      if (z.at(u, v) < z.at(nearest.x, nearest.y)) nearest = {u, v};
  }
  return nearest;
}

}  // namespace

ImageF logPicture(const ImageF& I, double bias) {
  ImageF L(I.width(), I.height());
  forEachPixel(I, [&](int x, int y) {
    L.at(x, y) = std::log(static_cast<float>(bias) + clampTo(I.at(x, y), 0, kMaxLuminance));
  });
  return L;
}

TaskTruth truthOf(const Bench& bench, double bias, TilePool& pool) {
  Feed features = bench.features();
  TaskTruth truth{features.config().camera, logPicture(bench.truth().front().change.I_prev, bias), {}};
  for (int t = 1; t <= bench.setup().last; ++t) {
    features.step(pool);
    const int scored = t - bench.setup().first;
    if (scored >= 0)
      truth.frames.push_back(frameOf(features, bench.truth()[static_cast<std::size_t>(scored)].change, bias));
    if (interrupted()) throw Interrupted{};
  }
  return truth;
}

const TruthFrame& TaskTruth::frameAt(TimeNs t) const {
  const auto after = std::partition_point(frames.begin(), frames.end(),
                                          [&](const TruthFrame& frame) { return frame.t1 <= t; });
  return after == frames.end() ? frames.back() : *after;
}

Vec2 TaskTruth::flowAt(Vec2 position, TimeNs t) const {
  const TruthFrame& frame = frameAt(t);
  const PixelPlace p = nearestAround(frame.z, position);
  return {frame.flow_x.at(p.x, p.y), frame.flow_y.at(p.x, p.y)};
}

float TaskTruth::depthAt(Vec2 position, TimeNs t) const {
  const TruthFrame& frame = frameAt(t);
  const PixelPlace p = nearestAround(frame.z, position);
  return frame.z.at(p.x, p.y);
}

Vec2 TaskTruth::carried(Vec2 position, TimeNs from, TimeNs to) const {
  while (from < to) {
    const TimeNs frame_end = frameAt(from).t1;
    const TimeNs next = from < frame_end ? std::min(frame_end, to) : to;
    const Vec2 flow = flowAt(position, from);
    const auto span = static_cast<float>(seconds(next - from));
    position = {position.x + flow.x * span, position.y + flow.y * span};
    from = next;
  }
  return position;
}

bool TaskTruth::hasBodies() const {
  bool shows_body = false, shows_other = false;
  for (const TruthFrame& frame : frames)
    forEachPixel(frame.body, [&](int x, int y) { (frame.body.at(x, y) ? shows_body : shows_other) = true; });
  return shows_body && shows_other;
}

bool TaskTruth::onlyTurns() const {
  return std::all_of(frames.begin(), frames.end(), [](const TruthFrame& frame) {
    return length(frame.camera.linear) == 0 && length(frame.camera.angular) > 0;
  });
}

bool TaskTruth::goes() const {
  return std::all_of(frames.begin(), frames.end(),
                     [](const TruthFrame& frame) { return length(frame.camera.linear) > 0; });
}

}  // namespace saccade::eval
