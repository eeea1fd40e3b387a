#include "eval/bench/cells.h"

#include "eval/bench/open_scene.h"
#include "eval/pictures/text.h"

namespace saccade::eval {

std::string Cell::framesText() const {
  return frames.first == frames.last ? format("%d", frames.last) : format("%d:%d", frames.first, frames.last);
}

std::string Cell::name() const {
  return sceneName(scene) + ' ' + motion + ' ' + format("%gpx", px_per_frame) + ' ' + framesText();
}

BenchSetup Cell::setup(BenchSetup common) const {
  common.scene = scene, common.trajectory = motion, common.px_per_frame = px_per_frame;
  common.first = frames.first, common.last = frames.last;
  return common;
}

std::vector<Cell> CellGrid::cells() const {
  std::vector<Cell> all;
  for (const std::string& scene : scenes)
    for (const std::string& motion : motions)
      for (const FrameRange& range : frames)
        for (const double speed : speeds) all.push_back({scene, motion, speed, range});
  return all;
}

std::string whyLeftOut(const Cell& cell, const BenchView& view) {
  if (view.surface < kLeastSurface)
    return format("only %.0f %% of the pixels show a surface", 100 * view.surface);
  if (cell.motion != kStillCamera && view.px_per_frame < kLeastOfSpeed * cell.px_per_frame)
    return "the images stand still";
  return {};
}

}  // namespace saccade::eval
