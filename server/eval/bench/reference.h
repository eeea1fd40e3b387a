// The truth that methods are measured against: every frame rendered with the same many seeds, so that the
// difference of two frames is a converged correlated estimate. Two independent halves tell its own error.
#pragma once

#include <string>

#include "base/tile_pool.h"
#include "eval/bench/progress.h"
#include "frame/intensity_change.h"
#include "render/renderer.h"
#include "scene/emitter_strengths.h"

namespace saccade::eval {

// Luminance of one frame; each half is the mean of spp/2 paths per pixel.
struct ReferenceFrame {
  ReferenceFrame(int w, int h) : a(w, h), b(w, h) {}
  ImageF a, b;
  float mean(int x, int y) const { return 0.5f * (a.at(x, y) + b.at(x, y)); }
};

// The change between two frames.
struct ReferenceChange {
  ReferenceChange(const ReferenceFrame& prev, const ReferenceFrame& cur);
  IntensityChange change;  // the mean of both halves, with its own variances; times are the caller's
  ImageF half_a, half_b;   // independent estimates of dI
  double error() const;    // of dI, relative L1: half of what the halves differ by
};

class ReferenceRenderer {
 public:
  // Finished and half-finished frames are kept in `cache`, named by a hash of scene, view and settings: not
  // of the code, so empty the folder after a change of the path tracer. With settings.jitter it is the mean
  // over the whole pixel.
  ReferenceRenderer(std::shared_ptr<const RenderScene> scene, RenderSettings settings, int width, int height,
                    double fov_x_deg, std::string cache, TilePool& pool);

  // The frame at a stream time, of `spp` paths per pixel, rounded up to whole chunks: rendered, or taken from
  // the cache. What was rendered is written every few seconds and when interrupted() turns true, and is gone
  // on with next time; a file that cannot be read, or is no such frame, is rendered anew. Frames of different
  // spp are kept apart: their difference would be noise of the paths that only one of them has.
  ReferenceFrame frame(const Pose& pose, TimeNs time, int spp, Progress& progress);

  static constexpr int kChunk = 64;  // paths per pixel between two looks at the clock

 private:
  std::string cachePath(const Pose& pose, int spp) const;  // with strengths_ at the frame's time

  Renderer renderer_;
  EmitterStrengths strengths_;
  bool whole_pixel_;
  int width_, height_;
  double fov_x_deg_;
  std::string cache_;
  std::uint64_t key_;
};

}  // namespace saccade::eval
