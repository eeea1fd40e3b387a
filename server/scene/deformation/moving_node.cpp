#include "scene/deformation/moving_node.h"

#include <array>

namespace saccade {
namespace {

Quaternion quaternion(const std::array<double, 4>& v) {
  const Quaternion q{v[0], v[1], v[2], v[3]};
  return isRotation(q) ? normalize(q) : Quaternion{};
}

}  // namespace

Affine LocalTransform::affine() const {
  if (matrix) return *matrix;
  return {rotate(rotation, {scale.x, 0, 0}), rotate(rotation, {0, scale.y, 0}),
          rotate(rotation, {0, 0, scale.z}), translation};
}

LocalTransform transformAt(LocalTransform local, std::span<const NodeTrack> tracks, double seconds) {
  for (const NodeTrack& track : tracks) {
    if (track.keys.times.empty()) continue;
    std::array<double, 4> v{};
    track.keys.at(seconds, std::span(v).first(track.keys.size));
    using Property = NodeTrack::Property;
    if (track.property == Property::kRotation) local.rotation = quaternion(v);
    if (track.property == Property::kTranslation) local.translation = {v[0], v[1], v[2]};
    if (track.property == Property::kScale) local.scale = {v[0], v[1], v[2]};
  }
  return local;
}

std::span<const Affine> NodePoses::at(double seconds) {
  if (seconds_ == seconds) return worlds_;
  seconds_ = seconds;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    const MovingNode& node = nodes_[i];
    const Affine local = transformAt(node.rest, node.tracks, seconds).affine();
    worlds_[i] = node.parent ? worlds_[*node.parent] * local : local;
  }
  return worlds_;
}

}  // namespace saccade
