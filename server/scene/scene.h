// The value description of a scene: what a scene file says, in world space, and nothing a scene here lacks.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "base/vec.h"
#include "scene/pose.h"
#include "scene/strength.h"
#include "scene/texture.h"

namespace saccade {

// Diffuse reflectance over the surface: linear RGB in [0, 1].
struct Reflectance {
  enum class Kind { kConstant, kBitmap, kCheckerboard };
  Kind kind = Kind::kConstant;
  Rgb color0, color1;                    // kConstant: color0; kCheckerboard: the two colours
  int texture = -1;                      // kBitmap: index into Scene::textures
  Vec2 uv_scale{1, 1}, uv_offset{0, 0};  // texture coordinate = uv * uv_scale + uv_offset
};

struct Material {
  std::string name;
  Reflectance reflectance;
  bool twosided = false;  // false: black seen from behind the geometric normal
};

// Triangles share positions with Embree: `positions` has one spare entry at the end, which Embree may read.
struct Mesh {
  std::string name;
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;  // per vertex, unit; empty: flat
  std::vector<Vec2> uvs;      // per vertex; empty: none
  std::vector<std::array<std::uint32_t, 3>> triangles;
  int material = 0;
  Rgb radiance;            // emitted on the side of the geometric normal (counter-clockwise front); 0: none
  Strength strength = {};  // of radiance, over time
};

struct Sphere {
  std::string name;
  Vec3 center;
  float radius = 1;
  int material = 0;
  Rgb radiance;            // emitted outwards; 0: none
  Strength strength = {};  // of radiance, over time
};

struct Scene {
  std::string name;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<Mesh> meshes;
  std::vector<Sphere> spheres;
  Pose T_world_camera;            // the sensor of the scene file; camera axes x right, y down, z forward
  double fov_x_deg = 45;          // horizontal field of view
  int width = 256, height = 256;  // the film of the scene file
};

// 1 if every reflectance, texture and radiance of the scene is grey, else 3.
int colorChannels(const Scene& scene);

}  // namespace saccade
