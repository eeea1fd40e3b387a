// The animations of a glTF file: how its nodes move over time [glTF 2.0, 3.11].
#pragma once

#include <vector>

#include "scene/gltf/gltf_accessor.h"
#include "scene/gltf/gltf_nodes.h"
#include "scene/gltf/key_track.h"

namespace saccade {

// All animations of a file, which play together from stream time 0 on.
class GltfAnimation {
 public:
  // Reads which nodes move. Keeps a reference to `nodes`. Throws SceneError.
  GltfAnimation(const JsonNode& root, const std::vector<GltfNode>& nodes);
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

  // Sentences on channels that are not shown.
  const std::vector<std::string>& unread() const { return unread_; }

 private:
  enum class Property { kTranslation, kRotation, kScale };
  struct Channel {
    Property property;
    JsonNode sampler;
    KeyTrack track;
  };
  LocalTransform localAt(std::size_t i, double seconds) const;
  void addChannel(const JsonNode& animation, const JsonNode& channel,
                  const std::vector<std::optional<std::size_t>>& places);
  std::vector<double> timesOf(std::size_t i, bool steps) const;

  const JsonNode root_;
  const std::vector<GltfNode>& nodes_;
  std::vector<std::vector<Channel>> channels_;  // by node
  std::vector<std::string> unread_;
  double length_ = 0;
};

}  // namespace saccade
