// Paths of what an animation of a glTF file moves.
#pragma once

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

// The motion of a body around `centre` (world) that is fixed to node i; none where it stands. Adds a sentence
// to `unread` where its form changes.
std::optional<OwnMotion> bodyMotion(const GltfAnimation& animation, std::size_t i, const std::string& name,
                                    Vec3d centre, double radius, std::vector<std::string>& unread);

}  // namespace saccade
