// The direct light of lamps without extent, at the surfaces that pixels show. It is exact, by one shadow ray
// for each pixel and lamp, but for the weaker ones of many.
#pragma once

#include "render/lights/spot_weights.h"
#include "render/surface/scatter.h"
#include "render/tiles/ray_numbers.h"
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

inline Vec3 normalOf(const PlainStart& start) {
  return start.geometric_normal;
}
inline Vec3 normalOf(const SurfaceStart& start) {
  return start.path.surface.geometric_normal;
}

// Calls on_light(owner, luminance) for the light of each lamp that reaches a start: what its pixel emits, so
// that no filter sees it.
template <Shading S, class OnLight>
class DeltaLight {
 public:
  DeltaLight(const PosedScene& scene, const OnLight& on_light)
      : tracing_{scene, 0, {}}, on_light_(on_light), rays_(tracing_, tell_) {}

  // `scale`: of the light that the start reflects, to that of its pixel. Of many lamps, `numbers` choose.
  void add(std::uint32_t owner, const auto& start, float scale, const RayNumbers& numbers) {
    const Vec3 origin = leave(start);
    if (!lamps_.areFew()) return addSome(owner, start, origin, scale, numbers);
    for (std::size_t i = 0; i < lamps_.size(); ++i) ask(owner, start, reflectedOf(i, start, origin), scale);
  }
  void finish() { rays_.finish(); }

 private:
  struct Reflected {
    IncidentLight light;
    Rgb color;
  };
  Reflected reflectedOf(std::size_t lamp, const auto& start, Vec3 origin) const {
    const IncidentLight light = lamps_.at(lamp, origin);
    return {light, scattered<S>(start, light.direction) * light.radiance};
  }
  void ask(std::uint32_t owner, const auto& start, const Reflected& reflected, float scale) {
    if (!(luminance(reflected.color) * scale > 0)) return;
    const IncidentLight& light = reflected.light;
    pending_[next_] = {owner, reflected.color * scale};
    rays_.add({leaveTowards(start, light.direction), light.segment, light.reach, next_});
    next_ = (next_ + 1) % kPending;
  }
  // About what each lamp gives.
  void weigh(const auto& start, Vec3 origin, std::size_t first = 0) {
    for (std::size_t i = first; i < lamps_.size(); ++i)
      weights_[i] = luminance(reflectedOf(i, start, origin).color);
  }
  void weigh(const PlainStart& start, Vec3 origin) {
    const float reflected = luminance(start.reflectance) * std::numbers::inv_pi_v<float>;
    spots_.at(origin, start.shading_normal * reflected, weights_);
    weigh<PlainStart>(start, origin, spots_.size());
  }
  void addSome(std::uint32_t owner, const auto& start, Vec3 origin, float scale, const RayNumbers& numbers) {
    const Lamps& all = tracing_.scene.lights().lamps();
    const LampSight::Shares* seen =
        all.hasTree(LightSet::kAll) ? all.tree(LightSet::kAll).seenFrom({origin, normalOf(start)}) : nullptr;
    weigh(start, origin);
    picks_.clear();
    for (std::size_t i = 0; i < lamps_.size(); ++i)
      if (weights_[i] > 0) picks_.add(static_cast<std::uint32_t>(i), weights_[i] * lamps_.shareSeen(i, seen));
    for (const LampPicks::Pick& pick : picks_.choose(numbers.u(0, 0)))
      ask(owner, start, reflectedOf(pick.lamp, start, origin), scale * pick.factor);
  }

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
  const DeltaLamps& lamps_ = tracing_.scene.deltaLamps();
  const OnLight& on_light_;
  const Tell tell_{*this};
  LampPicks picks_;
  const SpotWeights spots_{lamps_.areFew() ? std::span<const SpotLight>{}
                                           : tracing_.scene.lights().lamps().spots()};
  alignas(64) float weights_[LampPicks::kMost];  // of many lamps
  std::array<Pending, kPending> pending_;
  std::uint32_t next_ = 0;
  TileShadowRays<S, Tell> rays_;
};

}  // namespace saccade
