// Samples for methods that keep light on surfaces rather than in pixels: where they lie, and their light in
// parts.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/vec.h"

namespace saccade {

// What light a surface point can share with the points around it.
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

// A point that a pixel shows, and its light. All light is demodulated: a part of I - E, divided by the
// luminance of the albedo. Direct light that a diffuse base reflects has a closed form but for shadows, where
// lamps are simple:
//   i = unoccluded * visibility + rest,   visibility = visible_sample / unoccluded_sample in the mean.
// Where there is no such light, `unoccluded` is 0 and all light is in `rest`.
struct SurfacePoint {
  float share = 0;  // of the pixel's albedo that belongs to what the point stands for; 0: there is no point
  SurfaceKind kind = SurfaceKind::kNone;  // kNone: what follows up to `paths` means nothing
  Vec3 position;                          // where the surface seems to be, world space
  Vec3 normal;                            // unit shading normal, towards the camera
  float footprint = 0;                    // width of a pixel there, seen at a right angle, scene units
  float unoccluded = 0;                   // in closed form, as if nothing cast a shadow
  std::uint32_t paths = 0;                // that it gets, as the method plans
  bool baked = false;                     // whether its light is known ahead, as the method finds

  float unoccluded_sample = 0;  // an estimate of `unoccluded`, mean over the paths
  float visible_sample = 0;     // what of that estimate nothing stands in the way of
  float rest = 0;               // an estimate of all other light
  BounceSample bounce;          // of the last of the paths that did not end at known light

  // Whether it reflects light but cannot share it.
  bool isOther() const { return share > 0 && kind == SurfaceKind::kNone; }
};

class BounceGrid;

// The points of all pixels. A pixel shows `per_pixel` at most: one, unless there is jitter. Those of pixel x
// are the columns from x * per_pixel on.
class SurfaceSamples {
 public:
  SurfaceSamples(int width, int height, int per_pixel)
      : per_pixel_(per_pixel), columns_(width * per_pixel), points_(std::size_t(columns_) * height) {}

  int perPixel() const { return per_pixel_; }
  int columns() const { return columns_; }
  int height() const { return static_cast<int>(points_.size()) / columns_; }
  // The place of a column in row-major order.
  std::size_t indexOf(int column, int y) const { return std::size_t(y) * columns_ + column; }
  SurfacePoint& at(int column, int y) { return points_[indexOf(column, y)]; }
  const SurfacePoint& at(int column, int y) const { return points_[indexOf(column, y)]; }
  std::span<SurfacePoint> row(int y) { return {&at(0, y), std::size_t(columns_)}; }
  std::span<const SurfacePoint> row(int y) const { return {&at(0, y), std::size_t(columns_)}; }
  SurfacePoint& operator[](std::size_t index) { return points_[index]; }
  const SurfacePoint& operator[](std::size_t index) const { return points_[index]; }
  // Of the point at a place.
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
  bool showsOthers(int x, int y) const { return std::ranges::any_of(of(x, y), &SurfacePoint::isOther); }

  const BounceGrid* bounces = nullptr;  // light that ends paths at their second vertex, as the method has it

 private:
  int per_pixel_, columns_;
  std::vector<SurfacePoint> points_;
};

}  // namespace saccade
