// A triangle whose light varies over its surface, as a picture says.
#pragma once

#include "render/surface/surface_color.h"

namespace saccade {

struct LampPicture {
  // Of a triangle of a mesh.
  LampPicture(const Mesh& mesh, const std::array<std::uint32_t, 3>& triangle, const SurfaceColor& factor);

  // The radiance at a place of AreaLamp::at().
  Rgb at(const std::vector<Texture>& textures, float u1, float u2) const;
  // Of the triangle, from a few places. At least a hundredth of the mesh's, as light may lie in between.
  Rgb mean(const std::vector<Texture>& textures) const;

  Rgb radiance;                     // of the mesh, on average
  SurfaceColor color;               // a factor of it
  Vec2 corner{}, edge1{}, edge2{};  // in texture space; a mesh without coordinates has 0
};

}  // namespace saccade
