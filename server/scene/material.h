// The material of a surface.
#pragma once

#include <string>

#include "base/vec.h"
#include "scene/bsdf_model.h"

namespace saccade {

// A colour over the surface: linear RGB in [0, 1].
struct SurfaceColor {
  enum class Kind { kConstant, kBitmap, kCheckerboard };
  Kind kind = Kind::kConstant;
  Rgb color0, color1;                    // kConstant: color0; kCheckerboard: the two colours
  int texture = -1;                      // kBitmap: index into Scene::textures
  Vec2 uv_scale{1, 1}, uv_offset{0, 0};  // texture coordinate = uv * uv_scale + uv_offset
};

constexpr SurfaceColor constantColor(Rgb color) {
  SurfaceColor c;
  c.color0 = color;
  return c;
}
inline constexpr SurfaceColor kWhite = constantColor({1, 1, 1});

struct Material {
  std::string name;          // its id; without one, the type of its BSDF; "default" where a shape has none
  SurfaceColor reflectance;  // diffuse: all of it; plastics: of the base
  bool twosided = false;     // false: black seen from behind the geometric normal. Glass is never black
  BsdfModel model = {};
  SurfaceColor specular = kWhite;       // all but diffuse: factor of what the interface reflects
  SurfaceColor transmittance = kWhite;  // dielectrics: factor of what it lets through
  SurfaceColor opacity = kWhite;        // the rest of the light goes straight on, as if nothing were there
  // Bump map: luminance * height_scale is a displacement along the normal, in scene units. Only its changes
  // over the surface count.
  SurfaceColor height = {};
  float height_scale = 1;
};

inline bool isTextured(const SurfaceColor& c) {
  return c.kind != SurfaceColor::Kind::kConstant;
}
inline bool isTextured(const Material& m) {
  return isTextured(m.reflectance) || isTextured(m.specular) || isTextured(m.transmittance) ||
         isTextured(m.opacity) || isTextured(m.height);
}
inline bool isOpaque(const Material& m) {
  return !isTextured(m.opacity) && m.opacity.color0 == Rgb{1, 1, 1};
}
// Whether some light goes straight through, so that shadow rays go on.
inline bool transmitsStraight(const Material& m) {
  return traitsOf(m.model.kind).transmits_straight || !isOpaque(m);
}
inline bool isBumpy(const Material& m) {
  return isTextured(m.height) && m.height_scale != 0;
}

}  // namespace saccade
