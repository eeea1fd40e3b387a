// Counts what a scene holds, and the memory it takes.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "scene/scene.h"

namespace saccade {

struct SceneStats {
  std::size_t triangles = 0, meshes = 0, spheres = 0;
  std::map<BsdfKind, int> materials;  // how many of each kind
  int masks = 0, bump_maps = 0;       // materials that have one
  int area_lights = 0;                // shapes that emit
  int environments = 0, point_lights = 0, spot_lights = 0, directional_lights = 0;
  std::size_t textures = 0;        // bitmaps
  std::size_t texture_bytes = 0;   // with their mip chains, and the environment's picture
  int channels = 0;                // that carry light: 1 or 3
  std::size_t geometry_bytes = 0;  // of meshes and spheres; Embree's tree over them comes on top

  double bytesPerTriangle() const;  // of geometry; 0 without triangles
  // One line for people that lists what is there: "36 triangles in 8 meshes (70 bytes each); 5 diffuse; ...".
  std::string text() const;
};

SceneStats statsOf(const Scene& scene);

}  // namespace saccade
