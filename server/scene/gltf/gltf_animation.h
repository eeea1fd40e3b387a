// The animations of a glTF file: how its nodes move over time [glTF 2.0, 3.11].
#pragma once

#include <vector>

#include "scene/gltf/gltf_accessor.h"
#include "scene/gltf/gltf_nodes.h"
#include "scene/motion/own_motions.h"

namespace saccade {

// The names of all animations of a file, in its order; by number where there is none.
std::vector<std::string> animationNames(const JsonNode& root);

// The animations of a file that play, from stream time 0 on. They are the chosen one, or all of those that
// move other properties of nodes than those before them.
class GltfAnimation {
 public:
  // Reads which nodes move. Keeps a reference to `nodes`. Throws SceneError.
  GltfAnimation(const JsonNode& root, const std::vector<GltfNode>& nodes,
                const std::optional<ChosenAnimation>& chosen);
  // Reads the keys. Before that, nothing moves. Throws SceneError.
  void readKeys(const GltfBuffers& buffers);

  // The node that moves node i of the list: itself, or the nearest one above it that has keys.
  std::optional<std::size_t> moverOf(std::size_t i) const;
  // From the space of a node to that of the scene.
  Affine worldAt(std::size_t i, double seconds) const;
  // The times of the keys of all that moves the node, increasing.
  std::vector<double> keyTimes(std::size_t i) const;
  // Where the motion jumps: between these times and just before.
  std::vector<double> stepTimes(std::size_t i) const;
  double length() const { return length_; }  // the time of the last key, seconds
  // Whether the weights of the morph targets of node i have keys, and these keys.
  bool morphs(std::size_t i) const { return weights_[i].has_value(); }
  const KeyTrack& weightKeys(std::size_t i) const { return weights_[i]->keys; }
  // Node i as one of Scene::nodes, whose parent is `parent`.
  MovingNode movingNode(std::size_t i, std::size_t parent) const;

  // Sentences on animations that do not play.
  const std::vector<std::string>& unread() const { return unread_; }

 private:
  struct WeightTrack {
    JsonNode sampler;
    KeyTrack keys;
  };
  LocalTransform localAt(std::size_t i, double seconds) const {
    return transformAt(nodes_[i].rest, tracks_[i], seconds);
  }
  void addAnimation(const JsonNode& animation);
  void addChannel(const JsonNode& animation, const JsonNode& channel);
  bool isTaken(const JsonNode& channel) const;
  std::vector<double> timesOf(std::size_t i, bool steps) const;

  const JsonNode root_;
  const std::vector<GltfNode>& nodes_;
  std::vector<std::optional<std::size_t>> places_;   // in the list of nodes, by index in the file
  std::vector<std::vector<NodeTrack>> tracks_;       // by node
  std::vector<std::vector<JsonNode>> samplers_;      // of these tracks
  std::vector<std::optional<WeightTrack>> weights_;  // by node
  std::vector<std::string> unread_;
  double length_ = 0;
};

}  // namespace saccade
