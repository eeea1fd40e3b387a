// The direct light of lamps without extent, at the surfaces that pixels show: exact, by one shadow ray for
// each pixel and lamp.
#pragma once

#include "render/surface/scatter.h"
#include "render/tiles/surface_start.h"
#include "render/tiles/tile_shadow_rays.h"

namespace saccade {

// f |cos| of a start for light from the unit direction w.
template <Shading S>
Rgb scattered(const PlainStart& start, Vec3 w) {
  const float cosine = dot(w, start.geometric_normal) > 0 ? dot(w, start.shading_normal) : 0;
  return start.reflectance * (std::max(0.f, cosine) * std::numbers::inv_pi_v<float>);
}
template <Shading S>
Rgb scattered(const SurfaceStart& start, Vec3 w) {
  return Scatter<S>(start.path.surface, start.path.direction).evaluate(w).value;
}

inline Vec3 leave(const PlainStart& start) {
  return start.point + start.geometric_normal * start.offset;
}
inline Vec3 leave(const SurfaceStart& start) {
  return leave(start.path.surface);
}

// In the direction w: rough glass lets some light through.
inline Vec3 leaveTowards(const PlainStart& start, Vec3) {
  return leave(start);
}
inline Vec3 leaveTowards(const SurfaceStart& start, Vec3 w) {
  return leave(start.path.surface, dot(w, start.path.surface.geometric_normal) < 0);
}

// Calls on_light(owner, luminance) for the light of each lamp that reaches a start: what its pixel emits, so
// that no filter sees it.
template <Shading S, class OnLight>
class DeltaLight {
 public:
  DeltaLight(const PosedScene& scene, const OnLight& on_light)
      : tracing_{scene, 0, {}}, on_light_(on_light), rays_(tracing_, tell_) {}

  // `scale`: of the light that the start reflects, to that of its pixel.
  void add(std::uint32_t owner, const auto& start, float scale) {
    const RenderScene& scene = tracing_.scene.still();
    const DeltaLamps& lamps = scene.deltaLamps();
    const Vec3 origin = leave(start);
    for (std::size_t i = 0; i < lamps.size(); ++i) {
      const IncidentLight light = lamps.at(i, origin);
      const Rgb reflected = scattered<S>(start, light.direction) * light.radiance;
      if (!(luminance(reflected) * scale > 0)) continue;
      pending_[next_] = {owner, reflected * scale};
      rays_.add({leaveTowards(start, light.direction), light.segment, light.reach, next_});
      next_ = (next_ + 1) % kPending;
    }
  }
  void finish() { rays_.finish(); }

 private:
  struct Pending {
    std::uint32_t owner;
    Rgb light;
  };
  struct Tell {
    DeltaLight& of;
    void operator()(const ShadowRay& ray, Rgb fraction) const {
      const Pending& p = of.pending_[ray.owner];
      of.on_light_(p.owner, luminance(p.light * fraction));
    }
  };
  static constexpr std::uint32_t kPending = 32;  // more than the rays of a packet

  const Tracing tracing_;
  const OnLight& on_light_;
  const Tell tell_{*this};
  std::array<Pending, kPending> pending_;
  std::uint32_t next_ = 0;
  TileShadowRays<S, Tell> rays_;
};

}  // namespace saccade
