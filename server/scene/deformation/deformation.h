// Meshes whose vertices are a function of time: skins and morph targets [glTF 2.0, 3.7.2.2, 3.7.3].
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "base/units.h"
#include "scene/deformation/moving_node.h"

namespace saccade {

struct Joint {
  std::optional<std::size_t> node;  // of Scene::nodes; none: it stands
  Affine from_mesh;                 // from the space of the mesh to that of the node; of none to the scene's
};

// How far each vertex goes at a weight of 1.
struct MorphTarget {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;  // empty: they stay
};

// Joints that move a vertex, and their shares.
struct Influence {
  std::array<std::uint16_t, 4> joints{};
  std::array<float, 4> weights{1, 0, 0, 0};
};

// A vertex goes first by the targets, and then by the joints.
struct Deformation {
  std::vector<Vec3> positions, normals;  // per vertex, in the space of the mesh; without normals it is flat
  std::vector<MorphTarget> targets = {};
  std::vector<double> weights = {};  // of the targets, where the track has no keys
  KeyTrack weight_keys = {};
  std::vector<Joint> joints = {};  // at least one
  // For each vertex as many, of which the shares sum up to 1; empty: the first joint moves all.
  std::vector<Influence> influences = {};
  TimeNs period{0};  // it repeats; 0: it stays as it is after the last key
};

std::size_t bytesOf(const Deformation& deformation);

// From the space of the mesh to that of the scene file: columns x, y, z and translation.
using JointMap = std::array<float, 12>;

// The state of a deformation at one time. Meshes in equal states are equal.
struct MeshForm {
  std::vector<double> weights;
  std::vector<JointMap> joints;

  friend bool operator==(const MeshForm&, const MeshForm&) = default;
};

// `t`: at least 0. `nodes`: Scene::nodes. Allocates nothing where `form` was set before.
void setForm(const Deformation& deformation, NodePoses& nodes, TimeNs t, MeshForm& form);

// Sets the positions and the unit normals of all vertices, in the place that the scene file gives the mesh.
// Positions may have a spare one.
void deform(const Deformation& deformation, const MeshForm& form, std::span<Vec3> positions,
            std::span<Vec3> normals);

bool isMirrored(const MeshForm& form);  // by its first joint

}  // namespace saccade
