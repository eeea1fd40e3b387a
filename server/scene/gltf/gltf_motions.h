// Paths of what an animation of a glTF file moves.
#pragma once

#include <string>
#include <vector>

#include "scene/gltf/gltf_animation.h"
#include "scene/scene.h"

namespace saccade {

// The poses T_world_camera of node i, from its axes: x right, y up, z backward.
std::vector<TimedPose> cameraPath(const GltfAnimation& animation, std::size_t i, double reach);
Pose cameraPose(const Affine& world);

// A path that repeats with the length of all animations where it ends as it began. Else it stands at its end.
Trajectory playedPath(std::vector<TimedPose> poses, double length, double reach);

// Whether what is fixed to node i keeps its size while it moves.
bool staysRigid(const GltfAnimation& animation, std::size_t i);

// A body that is fixed to a node.
struct FixedBody {
  std::string name;
  Vec3d centre;   // world
  double radius;  // of what its motion changes: its shapes, or where its lamps shine
  bool has_shapes;
  bool turns;  // else its turning shows nowhere, as that of a point
};

// Of the shapes and lamps of `scene` with this name.
FixedBody fixedBody(const Scene& scene, const std::string& name);

// The motion of a body of node i; none where it stands. Adds a sentence to `unread` where its shapes change
// their form.
std::optional<OwnMotion> bodyMotion(const GltfAnimation& animation, std::size_t i, const FixedBody& body,
                                    std::vector<std::string>& unread);

}  // namespace saccade
