// Nodes of a tree that move over time, such as the joints of a skin.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "base/affine.h"
#include "scene/camera/pose.h"
#include "scene/deformation/key_track.h"

namespace saccade {

// From the space of a node to that of its parent: scaled, then turned, then moved. Instead of these, a
// matrix.
struct LocalTransform {
  Vec3d translation;
  Quaternion rotation;
  Vec3d scale{1, 1, 1};
  std::optional<Affine> matrix = {};

  Affine affine() const;
};

// Keys of a part of a LocalTransform. A track without keys changes nothing.
struct NodeTrack {
  enum class Property { kTranslation, kRotation, kScale };
  Property property;
  KeyTrack keys;
};

LocalTransform transformAt(LocalTransform rest, std::span<const NodeTrack> tracks, double seconds);

struct MovingNode {
  std::optional<std::size_t> parent;  // before it in its list
  LocalTransform rest;                // without its tracks
  std::vector<NodeTrack> tracks = {};
};

// The poses of all nodes of a list at one time.
class NodePoses {
 public:
  explicit NodePoses(std::span<const MovingNode> nodes) : nodes_(nodes), worlds_(nodes.size()) {}

  // From the space of each node to that of the scene. Stays until the next call.
  std::span<const Affine> at(double seconds);

 private:
  std::span<const MovingNode> nodes_;
  std::vector<Affine> worlds_;
  std::optional<double> seconds_;
};

}  // namespace saccade
