// A scene as plain data, independent of the format of its file. Its axes are those of the world, but their
// origin is where scene_origin.h says.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/vec.h"
#include "scene/body.h"
#include "scene/camera/pose.h"
#include "scene/camera/trajectory.h"
#include "scene/deformation/deformation.h"
#include "scene/light.h"
#include "scene/material.h"
#include "scene/strength.h"
#include "scene/texture.h"

namespace saccade {

inline constexpr int kKeepsForm = -1;  // instead of the number of a deformation

// Embree reads `positions` in place, and may read one entry beyond the last: there is a spare one.
struct Mesh {
  std::string name;  // its id; without one, that of the file without folder and extension, or its type
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;          // per vertex, unit; empty: flat
  std::vector<Vec2> uvs;              // per vertex; empty: none
  std::vector<Vec2> second_uvs = {};  // per vertex, for textures that have it; empty: none
  std::vector<Rgb> colors = {};  // per vertex: factors in [0, 1] of the base colour of metallic-roughness
  std::vector<std::array<std::uint32_t, 3>> triangles;
  int material = 0;
  Rgb radiance;  // mean, emitted on the side of the geometric normal (counter-clockwise front); 0: none
  Strength strength = {};   // of radiance, over time
  std::string unread = {};  // a sentence on what its file says and the picture does not show; empty: nothing
  int body = kStands;       // of Scene::bodies
  int deformation = kKeepsForm;  // of Scene::deformations: how it changes as part of a body
};

// Whether a mesh changes its form.
inline bool deforms(const Mesh& mesh) {
  return mesh.body != kStands && mesh.deformation != kKeepsForm;
}

struct Sphere {
  std::string name;  // its id; without one "sphere"
  Vec3 center;
  float radius = 1;
  int material = 0;
  Rgb radiance;            // emitted outwards; 0: none
  Strength strength = {};  // of radiance, over time
  int body = kStands;      // of Scene::bodies
};

// Whether a mesh or a sphere is a light.
inline bool emits(const auto& shape) {
  return luminance(shape.radiance) > 0;
}

// A motion that the scene's folder gives an object. It moves where a body is made of that.
struct OwnMotion {
  std::string name;                     // of shapes and lamps
  std::string text;                     // KIND:SPEED, or the name of a file of poses
  std::optional<Trajectory> path = {};  // of a file, T_world_body
  std::size_t poses = 0;                // of the path
};

// A camera path that the scene's file has.
struct ScenePath {
  std::string name;
  Trajectory path;  // T_world_camera
};

struct Scene {
  std::string name;
  std::vector<Material> materials;
  std::vector<Texture> textures;
  std::vector<Mesh> meshes;
  std::vector<Sphere> spheres;
  std::optional<Environment> environment = {};
  std::vector<PointLight> point_lights = {};
  std::vector<SpotLight> spot_lights = {};
  std::vector<DirectionalLight> directional_lights = {};
  std::vector<Body> bodies = {};  // what may move; all other shapes stand
  std::vector<Deformation> deformations = {};
  std::vector<MovingNode> nodes = {};   // that deformations follow
  std::vector<OwnMotion> motions = {};  // sorted by name
  std::vector<ScenePath> paths = {};    // of the cameras of its file
  Vec3d origin = {};                    // of its axes, in the world
  Pose T_world_camera;            // the sensor of the scene file; camera axes x right, y down, z forward
  double fov_x_deg = 45;          // horizontal field of view
  int width = 256, height = 256;  // the film of the scene file
  std::vector<std::string> unread = {};  // sentences on what its file says and the picture does not show
  std::optional<int> bounces = {};       // indirect ones of the author's picture; none: not said, or endless
};

// 1 where all colours are grey: of surfaces, textures, metals and lights. Else 3.
int colorChannels(const Scene& scene);

}  // namespace saccade
