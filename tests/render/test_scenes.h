// Scenes with known light, made of few triangles.
#pragma once

#include "scene/scene.h"

namespace saccade::test {

// A parallelogram with its geometric normal along cross(e1, e2).
inline Mesh quad(Vec3 corner, Vec3 e1, Vec3 e2, int material, Rgb radiance = {}) {
  Mesh m;
  m.positions = {corner, corner + e1, corner + e1 + e2, corner + e2, {}};
  m.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  m.triangles = {{0, 1, 2}, {0, 2, 3}};
  m.material = material;
  m.radiance = radiance;
  return m;
}

inline Material grey(float albedo, bool twosided = true) {
  Material m;
  m.reflectance.color0 = {albedo, albedo, albedo};
  m.twosided = twosided;
  return m;
}

// A closed cube of side 2 about the origin, all inner faces of one albedo and radiance, the camera inside.
inline Scene furnace(float albedo, float radiance) {
  Scene s;
  s.materials = {grey(albedo)};
  const Rgb e{radiance, radiance, radiance};
  s.meshes = {quad({-1, -1, -1}, {0, 2, 0}, {0, 0, 2}, 0, e), quad({1, -1, -1}, {0, 0, 2}, {0, 2, 0}, 0, e),
              quad({-1, -1, -1}, {0, 0, 2}, {2, 0, 0}, 0, e), quad({-1, 1, -1}, {2, 0, 0}, {0, 0, 2}, 0, e),
              quad({-1, -1, -1}, {2, 0, 0}, {0, 2, 0}, 0, e), quad({-1, -1, 1}, {0, 2, 0}, {2, 0, 0}, 0, e)};
  s.T_world_camera.position = {0.1, 0.2, -0.3};
  s.fov_x_deg = 80;
  return s;
}

// A floor z = 0 seen from above (the camera looks along -z); lights are for the test to add.
inline Scene floorFromAbove(float albedo) {
  Scene s;
  s.materials = {grey(albedo)};
  s.meshes = {quad({-5, -5, 0}, {10, 0, 0}, {0, 10, 0}, 0)};
  s.T_world_camera = {{0, 0, 3}, {1, 0, 0, 0}};  // half a turn about x
  s.fov_x_deg = 1;
  return s;
}

}  // namespace saccade::test
