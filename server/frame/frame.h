// The renderer's output for a method: features and correlated samples of one frame. Pure data.
#pragma once

#include <cstdint>
#include <memory>
#include <utility>

#include "base/units.h"
#include "base/vec.h"
#include "frame/image.h"

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
};

// Radiance samples: Rec. 709 luminance, emission included. Pass 1 uses the seeds of the previous frame, pass
// 2 those of this frame [E (8)].
struct FrameSamples {
  FrameSamples(int w, int h) : I1(w, h), I2(w, h) {}
  ImageF I1, I2;
  int spp1 = 0, spp2 = 0;  // paths per pixel in each pass; a pass with none leaves its plane at 0
};

// What light a pixel's surface point can share with the points around it.
enum class SurfaceKind : std::uint32_t {
  kNone,     // nothing: no surface, or one whose light depends on the view, such as metal
  kDiffuse,  // reflects alike into all directions
  kMixed,    // nearly so: a plastic, or a surface seen in a mirror or through glass
};

// What a path has found from its second vertex on.
struct BounceSample {
  std::uint64_t cell = 0;  // that the vertex lies in, BounceCell::key; 0: there is no sample
  Rgb light;               // reflected radiance over albedo, of each colour
};
class BounceGrid;

// The same samples for methods that keep light on surfaces rather than in pixels: where they lie, and their
// light in parts. All light is demodulated: a part of I - E, divided by the luminance of the albedo.
// Direct light that a diffuse base reflects has a closed form but for shadows, where lamps are simple:
//   i = unoccluded * visibility + rest,   visibility = visible_sample / unoccluded_sample in the mean.
// Where there is no such light, `unoccluded` is 0 and all light is in `rest`.
struct SurfaceSamples {
  SurfaceSamples(int w, int h)
      : paths(w, h),
        kind(w, h),
        x(w, h),
        y(w, h),
        z(w, h),
        footprint(w, h),
        unoccluded(w, h),
        unoccluded_sample(w, h),
        visible_sample(w, h),
        rest(w, h),
        bounce(w, h) {}
  Image<std::uint32_t> paths;  // that a pixel gets, as the method plans; of kNone the spp of the frame
  Image<SurfaceKind> kind;     // kNone: the planes below mean nothing
  ImageF x, y, z;              // where the surface seems to be, world space
  ImageF footprint;            // width of a pixel there, seen at a right angle, scene units
  ImageF unoccluded;           // in closed form, as if nothing cast a shadow
  ImageF unoccluded_sample;    // an estimate of the same, mean over the paths; without any it means nothing
  ImageF visible_sample;       // what of that estimate nothing stands in the way of
  ImageF rest;                 // an estimate of all other light

  const BounceGrid* bounces = nullptr;  // light that ends paths at their second vertex, as the method has it
  Image<BounceSample> bounce;           // of the last of a pixel's paths that did not end there
};

// With `on_surfaces` also as SurfaceSamples.
struct Frame {
  Frame(int width, int height, bool on_surfaces = false) : g(width, height), samples(width, height) {
    if (on_surfaces) surfaces = std::make_unique<SurfaceSamples>(width, height);
  }
  int width() const { return g.z.width(); }
  int height() const { return g.z.height(); }
  FrameIndex index = 0;
  TimeNs time{0};
  bool light_changed = false;  // the strength of an emitter, since the frame before
  GBuffer g;
  FrameSamples samples;
  std::unique_ptr<SurfaceSamples> surfaces;  // nullptr where no method asks
};

// Two consecutive frames. A view; never stored.
struct FramePair {
  const Frame& cur;
  const Frame& prev;
};

// The two newest frames of a feed. swap() makes the current frame the previous one.
class FrameRing {
 public:
  FrameRing(int width, int height, bool on_surfaces)
      : cur_(width, height, on_surfaces), prev_(width, height, on_surfaces) {}
  Frame& current() { return cur_; }
  FramePair pair() const { return {cur_, prev_}; }
  void swap() { std::swap(cur_, prev_); }

 private:
  Frame cur_, prev_;
};

}  // namespace saccade
