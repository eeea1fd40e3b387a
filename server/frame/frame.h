// The renderer's output for a method: features and correlated samples of one frame. Pure data.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "base/units.h"
#include "frame/image.h"
#include "frame/pair_samples.h"
#include "frame/surface_samples.h"

namespace saccade {

// A ray that hits nothing counts as a hit on one far surface. To the filters it is a surface like any other.
// Its normal is (0, 0, 1).
inline constexpr float kMissDepth = 1e5f;  // its depth, scene units

// Features of the surface that the pixel centre shows. A flat mirror or clear glass shows another surface,
// where it appears to be. With jitter, albedo and emission are means over the pixel. Planes are width x
// height.
struct GBuffer {
  GBuffer(int w, int h)
      : z(w, h),
        dz(w, h),
        nx(w, h),
        ny(w, h),
        nz(w, h),
        albedo(w, h),
        emission(w, h),
        motion_x(w, h),
        motion_y(w, h),
        z_in_prev(w, h) {
    z.fill(kMissDepth);
  }
  ImageF z;           // depth along the viewing axis, scene units; kMissDepth where nothing is hit
  ImageF dz;          // max(|dz/dx|, |dz/dy|) of the tangent plane, scene units per pixel
  ImageF nx, ny, nz;  // unit shading normal, world space, towards the camera; 0 in the border
  ImageF albedo;      // fraction of light that is reflected into the view, Rec. 709 luminance, [0, 1]
  ImageF emission;    // Rec. 709 luminance emitted into the view, >= 0
  ImageF motion_x,
      motion_y;      // position of the surface point in the previous frame minus its position now, pixels
  ImageF z_in_prev;  // depth of the surface point in the previous camera, scene units
  // 1 + the number of the body that is shown, see Scene::bodies; 0: a surface that stands, or none. Empty
  // where the scene has no bodies.
  Image<std::uint32_t> body;
};

// Radiance samples: Rec. 709 luminance, emission included. Pass 1 uses the seeds of the previous frame, pass
// 2 those of this frame [E (8)].
struct FrameSamples {
  FrameSamples(int w, int h) : I1(w, h), I2(w, h) {}
  ImageF I1, I2;
  int spp1 = 0, spp2 = 0;  // paths per pixel in each pass; a pass with none leaves its plane at 0
};

// With SurfaceSamples too, if a pixel has `points`.
struct Frame {
  Frame(int width, int height, int points = 0) : g(width, height), samples(width, height) {
    if (points > 0) surfaces = std::make_unique<SurfaceSamples>(width, height, points);
  }
  int width() const { return g.z.width(); }
  int height() const { return g.z.height(); }
  FrameIndex index = 0;
  TimeNs time{0};
  std::uint64_t light = 0;  // the strengths of all emitters: equal numbers mean equal strengths
  bool stands = false;      // whether the camera and all bodies have the poses of the frame before
  GBuffer g;
  FrameSamples samples;                      // with SurfaceSamples, light of coats is not in them
  std::unique_ptr<SurfaceSamples> surfaces;  // nullptr where no method asks
  std::unique_ptr<PairSamples> pairs;        // of this frame where a method asked; else nullptr, or older
  std::unique_ptr<CoatSamples> coats;        // of this frame where it or the one before hasCoats(); likewise
};

// Two consecutive frames. A view; never stored.
struct FramePair {
  // The first frame of a history: it stands for the one before it too, and shows no difference.
  static FramePair first(const Frame& frame) { return {frame, frame, true}; }

  const Frame& cur;
  const Frame& prev;
  bool is_first = false;
};

// The two newest frames of a feed. swap() makes the current frame the previous one.
class FrameRing {
 public:
  FrameRing(int width, int height, int points) : cur_(width, height, points), prev_(width, height, points) {}
  Frame& current() { return cur_; }
  FramePair pair() const { return {cur_, prev_}; }
  void swap() { std::swap(cur_, prev_); }

 private:
  Frame cur_, prev_;
};

}  // namespace saccade
