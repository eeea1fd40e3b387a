// Samples for methods that keep light on surfaces rather than in pixels: where they lie, and their light in
// parts.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.h"

namespace saccade {

// The light that a surface point can share with the points around it.
enum class SurfaceKind : std::uint8_t {
  kNone,     // nothing: no surface, or one whose light depends on the view, such as metal
  kDiffuse,  // reflects alike into all directions
  kMixed,    // nearly so: a plastic, or a surface seen in a mirror or through glass
};

// The light that a path has found from its second vertex on.
struct BounceSample {
  std::uint64_t cell = 0;  // that the vertex lies in, BounceCell::key; 0: there is no sample
  Rgb light;               // reflected radiance over albedo, of each colour
};

// A point that a pixel shows: what all stages of a frame read.
struct SurfacePoint {
  float share = 0;  // of the pixel's albedo that belongs to what the point stands for; 0: there is no point
  SurfaceKind kind = SurfaceKind::kNone;
  bool light_moves = false;  // whether direct light may have changed since the frame before
  bool baked = false;        // whether its light is known ahead, as the method finds
  bool near_shadow = false;  // of a baked one: whether rays may tell its visibility
  std::uint32_t paths = 0;   // that it gets, as the method plans

  // Whether it reflects light that depends on the view, so that it cannot be shared.
  bool isUncacheable() const { return share > 0 && kind == SurfaceKind::kNone; }
  // Whether rays can tell its visibility.
  bool canAskRays() const { return share > 0 && kind != SurfaceKind::kNone && (!baked || near_shadow); }
};

// Where a point lies, unless it is of kNone.
struct SurfacePlace {
  Vec3 position;         // where the surface seems to be, world space; of a body as PosedBodies::cachePlace()
  Vec3 normal;           // unit shading normal, towards the camera
  float footprint = 0;   // width of a pixel there, seen at a right angle, scene units
  float unoccluded = 0;  // light in closed form, see SurfaceLight
};

// The light that the paths of a point have found, if it gets any. All light is demodulated: a part of I - E,
// divided by the luminance of the albedo. Direct light that a diffuse base reflects has a closed form but for
// shadows, where lamps are simple:
//   i = place.unoccluded * visibility + residual,   visibility = visible / unoccluded in the mean.
// Where there is no such light, all light is in `residual`.
struct SurfaceLight {
  float unoccluded = 0;  // an estimate of the closed form, as if nothing cast a shadow; mean over the paths
  float visible = 0;     // what of that estimate nothing stands in the way of
  float residual = 0;    // an estimate of all other light
  BounceSample bounce;   // of the last of the paths that did not end at known light
};

// The visibility of the lamps in closed form, by shadow rays from a point.
struct RayVisibility {
  float mean = 1;      // of what arrives, over the unoccluded
  float trust = 0;     // in it, against what else is known of visibility, [0, 1]
  float variance = 0;  // of it
};

// That of a point, and of the point of the frame before.
struct SurfaceShadow {
  static constexpr float kMoves = 1;  // `wanted` where a body may have moved into the light, or out of it

  // Variance of visibility that the method cannot tell; 0: there are no rays. At a point near_shadow, the
  // reader of baked light sets it before the method plans.
  float wanted = 0;
  RayVisibility now, before;
  int rays = 0;             // of the point, to all groups of lamps
  float step_variance = 0;  // of its change
};

// The points of all pixels. A pixel shows `per_pixel` at most: one, unless there is jitter. Those of pixel x
// are the columns from x * per_pixel on.
class SurfaceSamples {
 public:
  SurfaceSamples(int width, int height, int per_pixel)
      : per_pixel_(per_pixel),
        columns_(width * per_pixel),
        points_(std::size_t(columns_) * height),
        places_(points_.size()),
        lights_(points_.size()),
        shadows_(points_.size()) {}

  int perPixel() const { return per_pixel_; }
  int columns() const { return columns_; }
  int height() const { return static_cast<int>(points_.size()) / columns_; }
  // In row-major order.
  std::size_t indexOf(int column, int y) const { return std::size_t(y) * columns_ + column; }
  SurfacePoint& at(int column, int y) { return points_[indexOf(column, y)]; }
  const SurfacePoint& at(int column, int y) const { return points_[indexOf(column, y)]; }
  std::span<SurfacePoint> row(int y) { return {&at(0, y), std::size_t(columns_)}; }
  std::span<const SurfacePoint> row(int y) const { return {&at(0, y), std::size_t(columns_)}; }
  SurfacePoint& operator[](std::size_t index) { return points_[index]; }
  const SurfacePoint& operator[](std::size_t index) const { return points_[index]; }
  SurfacePlace& place(std::size_t index) { return places_[index]; }
  const SurfacePlace& place(std::size_t index) const { return places_[index]; }
  SurfaceLight& light(std::size_t index) { return lights_[index]; }
  const SurfaceLight& light(std::size_t index) const { return lights_[index]; }
  // The change of SurfaceLight::residual from what the same numbers find at the same points in the world of
  // the frame before. Empty unless a body has moved since, and where the strengths of lamps have changed.
  std::vector<float>& changes() { return changes_; }
  const std::vector<float>& changes() const { return changes_; }
  std::vector<SurfaceShadow>& shadows() { return shadows_; }
  const std::vector<SurfaceShadow>& shadows() const { return shadows_; }
  // Of the point with an index.
  int columnOf(std::uint32_t index) const {
    return static_cast<int>(index % static_cast<std::uint32_t>(columns_));
  }
  int rowOf(std::uint32_t index) const {
    return static_cast<int>(index / static_cast<std::uint32_t>(columns_));
  }
  // Those of one pixel. Some may not be there.
  std::span<SurfacePoint> of(int x, int y) { return row(y).subspan(x * per_pixel_, per_pixel_); }
  std::span<const SurfacePoint> of(int x, int y) const { return row(y).subspan(x * per_pixel_, per_pixel_); }

  // Whether a pixel shows something that reflects light but cannot share it.
  bool hasUncacheable(int x, int y) const {
    return std::ranges::any_of(of(x, y), [](const SurfacePoint& p) { return p.isUncacheable(); });
  }

  // Whether any point may get paths: not where nothing reflects but baked light.
  bool needPaths() const { return need_paths_; }
  // Whether any pixel hasUncacheable().
  bool hasUncacheable() const { return has_uncacheable_; }
  // Whether any point is near_shadow.
  bool nearShadows() const { return near_shadows_; }
  // Sets all three, once all points are known.
  void summarize(bool need_paths, bool has_uncacheable, bool near_shadows) {
    need_paths_ = need_paths, has_uncacheable_ = has_uncacheable, near_shadows_ = near_shadows;
  }
  // Whether any point may want rays, as the method plans. Otherwise shadows() has no meaning.
  bool wantShadows() const { return want_shadows_; }
  void setWantShadows(bool want) { want_shadows_ = want; }
  // Whether a point of a pixel wants rays.
  bool wantsShadows(int x, int y) const {
    if (!want_shadows_) return false;
    const std::size_t first = indexOf(x * per_pixel_, y);
    for (std::size_t i = first; i < first + static_cast<std::size_t>(per_pixel_); ++i)
      if (shadows_[i].wanted > 0) return true;
    return false;
  }

 private:
  int per_pixel_, columns_;
  bool need_paths_ = true, has_uncacheable_ = true, near_shadows_ = false, want_shadows_ = true;
  std::vector<SurfacePoint> points_;
  std::vector<SurfacePlace> places_;
  std::vector<SurfaceLight> lights_;
  std::vector<SurfaceShadow> shadows_;
  std::vector<float> changes_;
};

}  // namespace saccade
