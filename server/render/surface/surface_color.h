// Colours of surfaces at a point.
#pragma once

#include <algorithm>
#include <cmath>

#include "scene/scene.h"

namespace saccade {

// A point in texture space, and the width of the region to average over.
struct TexturePoint {
  Vec2 uv;
  float footprint;
};

// The mean over [x - w/2, x + w/2] of a square wave of period 1. The wave is +1 on [0, 1/2) and -1 on [1/2,
// 1).
inline float filteredSquareWave(float x, float w) {
  const auto integral = [](float t) {
    const float f = t - std::floor(t);
    return std::min(f, 1 - f);
  };
  w = std::max(w, 1e-5f);
  x -= std::floor(x);  // where floats are fine enough for so small a width
  return std::clamp((integral(x + w / 2) - integral(x - w / 2)) / w, -1.f, 1.f);
}

inline Rgb lookUp(const std::vector<Texture>& textures, const SurfaceColor& c, TexturePoint p) {
  if (c.kind == SurfaceColor::Kind::kConstant) return c.color0;
  const Vec2 st{p.uv.x * c.uv_scale.x + p.uv.y * c.uv_cross.x + c.uv_offset.x,
                p.uv.y * c.uv_scale.y + p.uv.x * c.uv_cross.y + c.uv_offset.y};
  const float width =
      p.footprint * std::sqrt(std::abs(c.uv_scale.x * c.uv_scale.y - c.uv_cross.x * c.uv_cross.y));
  if (c.kind == SurfaceColor::Kind::kBitmap) return textures[c.texture].sample(st, width);
  // In Mitsuba's checkerboard, color0 fills the squares where both coordinates lie in the same half of their
  // period.
  const float same = 0.5f + 0.5f * filteredSquareWave(st.x, width) * filteredSquareWave(st.y, width);
  return c.color0 * same + c.color1 * (1 - same);
}
inline Rgb lookUp(const Scene& scene, const SurfaceColor& c, TexturePoint p) {
  return lookUp(scene.textures, c, p);
}

}  // namespace saccade
