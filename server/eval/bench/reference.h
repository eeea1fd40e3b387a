// The truth that methods are measured against. All frames share their seeds, so that the difference of two
// frames is a converged correlated estimate. Two independent halves give its own error.
#pragma once

#include <string>

#include "base/tile_pool.h"
#include "eval/bench/progress.h"
#include "frame/intensity_change.h"
#include "render/renderer.h"

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
  ImageF prev_a, prev_b;   // and of I_prev
  double error() const;    // of dI: half the relative L1 distance of the halves
};

class ReferenceRenderer {
 public:
  // Keeps frames in the folder `cache`, named by a hash of scene, view and settings. The hash does not cover
  // the code: empty the folder after a change of the path tracer. With settings.jitter a frame is the mean
  // over the whole pixel. References of different seeds have nothing in common.
  // `body_paths`: of the bodies of the scene.
  ReferenceRenderer(std::shared_ptr<const RenderScene> scene, RenderSettings settings, int width, int height,
                    double fov_x_deg, std::string cache, TilePool& pool, std::uint64_t seed = 0,
                    const std::vector<Trajectory>& body_paths = {});

  // Renders the frame at a stream time, or takes it from the cache. `spp` paths per pixel are rounded up to a
  // multiple of kChunk. The cache is written every few seconds and when interrupted() turns true. The next
  // call continues from there, or starts anew where the file is not such a frame. Frames of different spp
  // have files of their own: their difference would hold the noise of the paths that only one of them has.
  ReferenceFrame frame(const Pose& pose, TimeNs time, int spp, Progress& progress);

  static constexpr int kChunk = 64;  // paths per pixel between two checks of the clock

 private:
  std::string cachePath(const Pose& pose, int spp) const;  // with posed_ at the frame's time
  Camera cameraAt(const Pose& pose, std::uint32_t chunk) const;

  PosedScene posed_;  // at the time of the frame
  Renderer renderer_;
  TilePool& pool_;
  bool whole_pixel_;
  int width_, height_;
  double fov_x_deg_;
  std::string cache_;
  std::uint64_t seed_;  // of all chunks
  Vec2 first_shift_;    // of the grid of pixels
  std::uint64_t key_;
};

}  // namespace saccade::eval
