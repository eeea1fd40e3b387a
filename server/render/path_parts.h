// What traceReflected() takes and tells besides its estimate.
#pragma once

#include <algorithm>
#include <optional>

#include "cache/bounce_grid.h"
#include "render/color.h"
#include "render/scatter.h"

namespace saccade {

// Light that ends paths at their second vertex.
struct KnownBounces {
  const BounceGrid* grid;  // nullptr: there is none
  Vec3 eye;                // of the camera
  float pixel;             // width of its pixels at the distance 1
};

// A path from its second vertex on. Light that is known there ends the path. What it finds there can be kept.
template <int Channels>
class PathTail {
 public:
  explicit PathTail(const KnownBounces& known) : known_(known) {}

  // At the second vertex. Returns the light that it reflects, if that is known. If not, but it can be kept,
  // the rest of the path is told apart: `radiance` and `throughput` begin anew. `width`: of the cone there.
  // `u`: random, in [0, 1).
  template <Shading S>
  std::optional<Color<Channels>> begin(const Surface& s, Vec3 arriving, float width, float u,
                                       Color<Channels>& radiance, Color<Channels>& throughput) {
    const Scatter<S> scatter(s, arriving);
    if (!known_.grid || !scatter.hasBase() || (S.extras && s.opacity < 1)) return {};
    const Rgb albedo = scatter.albedo();
    if (std::min({albedo.x, albedo.y, albedo.z}) < kLeastAlbedo) return {};
    const BounceCell cell(s.point, s.geometric_normal, known_.pixel * length(s.point - known_.eye));
    if (width < kLeastCone * cell.edge) return {};
    if (const auto light = known_.grid->find(cell, u)) return Color<Channels>(albedo * *light);
    cell_ = cell.key, albedo_ = albedo;
    before_ = radiance, carried_ = throughput;
    radiance = Color<Channels>(), throughput = Color<Channels>(1.f);
    return {};
  }

  // The light of the whole path. `radiance` is what it has found since it began anew.
  Color<Channels> end(const Color<Channels>& radiance) {
    if (cell_ == 0) return radiance;
    const Rgb found = radiance.rgb();
    sample_ = {cell_, {found.x / albedo_.x, found.y / albedo_.y, found.z / albedo_.z}};
    Color<Channels> all = before_;
    return all += carried_ * radiance;
  }
  const BounceSample& sample() const { return sample_; }  // of the path that has ended

 private:
  static constexpr float kLeastAlbedo = 1e-3f;
  // Of a cell's edge. Single cells would show where they are near, and in directions like a mirror's.
  static constexpr float kLeastCone = RayCone::kDiffuseSpread;

  const KnownBounces& known_;
  std::uint64_t cell_ = 0;  // 0: nothing is kept
  Rgb albedo_;
  Color<Channels> before_, carried_;
  BounceSample sample_;
};

// Nothing.
struct NoParts {
  static constexpr bool kKept = false;
  struct {
    template <class C>
    C end(const C& radiance) const {
      return radiance;
    }
  } tail;
};

// The light in parts. Direct light at the first vertex has a closed form but for shadows, see
// analytic_light.h.
template <int Channels>
struct PathParts {
  static constexpr bool kKept = true;
  explicit PathParts(const KnownBounces& known) : tail(known) {}
  Color<Channels> unoccluded,
      visible;              // what a white diffuse surface would reflect of a sample of that light
  Color<Channels> weighed;  // what of the path's own estimate is that light
  PathTail<Channels> tail;
};

}  // namespace saccade
