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
  Rgb color0, color1;  // kConstant: color0; kCheckerboard: the two colours
  int texture = -1;    // kBitmap: index into Scene::textures
  // The coordinates in the texture: (u, v) * uv_scale + (v, u) * uv_cross + uv_offset.
  Vec2 uv_scale{1, 1}, uv_offset{0, 0}, uv_cross{0, 0};
  bool second_uvs = false;  // u and v are Mesh::second_uvs
};

constexpr SurfaceColor constantColor(Rgb color) {
  SurfaceColor c;
  c.color0 = color;
  return c;
}
inline constexpr SurfaceColor kWhite = constantColor({1, 1, 1});

struct Material {
  std::string name;          // its id; without one, the type of its BSDF; "default" where a shape has none
  SurfaceColor reflectance;  // diffuse: all of it; metallic-roughness: the base colour; else that of the base
  bool twosided = false;     // false: black seen from behind the geometric normal. Glass is never black
  BsdfModel model = {};
  SurfaceColor specular = kWhite;       // all but diffuse: factor of what the interface or the gloss reflects
  SurfaceColor transmittance = kWhite;  // dielectrics: factor of what it lets through
  // Metallic-roughness, as in pictures of glTF: green is the roughness, whose square is alpha; blue the
  // metalness.
  SurfaceColor metallic_roughness = constantColor({0, 1, 0});
  SurfaceColor opacity = kWhite;   // the rest of the light goes straight on, as if nothing were there
  SurfaceColor emission = kWhite;  // factor of what its meshes emit, at least 0, with the mean 1
  // Bump map: luminance * height_scale is a displacement along the normal, in scene units. Only its changes
  // over the surface count.
  SurfaceColor height = {};
  float height_scale = 1;
  // Normal map: (colour * 2 - 1) is the normal, along the directions in which the texture's u and v grow, and
  // the surface's own normal. Without texture: none.
  SurfaceColor normals = {};
  float normals_scale = 1;  // of the first two
};

inline bool isTextured(const SurfaceColor& c) {
  return c.kind != SurfaceColor::Kind::kConstant;
}
inline bool isTextured(const Material& m) {
  return isTextured(m.reflectance) || isTextured(m.specular) || isTextured(m.transmittance) ||
         isTextured(m.metallic_roughness) || isTextured(m.opacity) || isTextured(m.emission) ||
         isTextured(m.height) || isTextured(m.normals);
}
inline bool isOpaque(const Material& m) {
  return !isTextured(m.opacity) && m.opacity.color0 == Rgb{1, 1, 1};
}
// Whether some light goes straight through, so that shadow rays go on.
inline bool transmitsStraight(const Material& m) {
  return traitsOf(m.model.kind).transmits_straight || !isOpaque(m);
}
// Whether a map bends the normals.
inline bool isBumpy(const Material& m) {
  return (isTextured(m.height) && m.height_scale != 0) || (isTextured(m.normals) && m.normals_scale != 0);
}

}  // namespace saccade
