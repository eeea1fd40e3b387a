#include "scene/gltf/gltf_animation.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace saccade {
namespace {

constexpr float kMostSeconds = 1e6f;

Quaternion quaternion(const std::array<double, 4>& v) {
  const Quaternion q{v[0], v[1], v[2], v[3]};
  return isRotation(q) ? normalize(q) : Quaternion{};
}

KeyInterpolation interpolationOf(const JsonNode& sampler) {
  const std::string name = sampler.text("interpolation", "LINEAR");
  if (name == "LINEAR") return KeyInterpolation::kLinear;
  if (name == "STEP") return KeyInterpolation::kStep;
  if (name == "CUBICSPLINE") return KeyInterpolation::kCubic;
  throw sampler.error("the interpolation is not LINEAR, STEP or CUBICSPLINE");
}

KeyTrack readTrack(const JsonNode& root, const JsonNode& sampler, const GltfBuffers& buffers,
                   std::size_t size) {
  const std::size_t accessors = root.count("accessors");
  KeyTrack track{interpolationOf(sampler), size, {}, {}};
  track.times = readFloats(root, buffers, sampler.at("input").index(accessors), 1);
  track.values = readFloats(root, buffers, sampler.at("output").index(accessors), size);
  const bool rises =
      std::ranges::adjacent_find(track.times, [](float a, float b) { return !(a < b); }) == track.times.end();
  if (track.times.empty() || !(track.times[0] >= 0) || !(track.times.back() <= kMostSeconds) || !rises)
    throw sampler.error("the times of its keys must rise from 0 or later to 1e6 s at most");
  const std::size_t values = track.interpolation == KeyInterpolation::kCubic ? 3 : 1;
  if (track.values.size() != values * size * track.times.size())
    throw sampler.error("has " + std::to_string(track.values.size() / size) + " values for " +
                        std::to_string(track.times.size()) + " keys");
  if (!std::ranges::all_of(track.values, [](float v) { return std::isfinite(v); }))
    throw sampler.error("a value is not finite");
  return track;
}

}  // namespace

GltfAnimation::GltfAnimation(const JsonNode& root, const std::vector<GltfNode>& nodes)
    : root_(root), nodes_(nodes), channels_(nodes.size()) {
  std::vector<std::optional<std::size_t>> places(root.count("nodes"));
  for (std::size_t i = 0; i < nodes.size(); ++i) places[nodes[i].index] = i;
  for (const JsonNode& animation : root.list("animations"))
    for (const JsonNode& channel : animation.list("channels")) addChannel(animation, channel, places);
}

void GltfAnimation::addChannel(const JsonNode& animation, const JsonNode& channel,
                               const std::vector<std::optional<std::size_t>>& places) {
  const JsonNode target = channel.at("target");
  const JsonNode sampler =
      animation.entry("samplers", channel.at("sampler").index(animation.count("samplers")));
  const auto node = target.index("node", places.size());
  if (!node || !places[*node]) return;
  const std::size_t i = *places[*node];
  const std::string path = target.at("path").text();
  if (path == "weights") {
    unread_.push_back("the shape of " + nodes_[i].name + " changes with morph targets; it keeps its first");
    return;
  }
  const bool turns = path == "rotation", scales = path == "scale";
  if (!turns && !scales && path != "translation")
    throw target.error("path is not translation, rotation, scale or weights");
  if (nodes_[i].rest.matrix) throw target.error("a node with a matrix cannot be animated");
  const Property property = turns ? Property::kRotation : scales ? Property::kScale : Property::kTranslation;
  for (const Channel& other : channels_[i])
    if (other.property == property) {
      unread_.push_back("the first of several animations of the " + path + " of " + nodes_[i].name +
                        " plays");
      return;
    }
  channels_[i].push_back({property, sampler, {}});
}

void GltfAnimation::readKeys(const GltfBuffers& buffers) {
  for (auto& channels : channels_)
    for (Channel& channel : channels) {
      channel.track =
          readTrack(root_, channel.sampler, buffers, channel.property == Property::kRotation ? 4 : 3);
      length_ = std::max(length_, static_cast<double>(channel.track.times.back()));
    }
}

std::optional<std::size_t> GltfAnimation::moverOf(std::size_t i) const {
  std::optional<std::size_t> node = i;
  while (node && channels_[*node].empty()) node = nodes_[*node].parent;
  return node;
}

LocalTransform GltfAnimation::localAt(std::size_t i, double seconds) const {
  LocalTransform local = nodes_[i].rest;
  for (const Channel& channel : channels_[i]) {
    if (channel.track.times.empty()) continue;
    const std::array<double, 4> v = channel.track.at(seconds);
    if (channel.property == Property::kRotation) local.rotation = quaternion(v);
    if (channel.property == Property::kTranslation) local.translation = {v[0], v[1], v[2]};
    if (channel.property == Property::kScale) local.scale = {v[0], v[1], v[2]};
  }
  return local;
}

Affine GltfAnimation::worldAt(std::size_t i, double seconds) const {
  Affine world = localAt(i, seconds).affine();
  for (auto node = nodes_[i].parent; node; node = nodes_[*node].parent)
    world = localAt(*node, seconds).affine() * world;
  return world;
}

std::vector<double> GltfAnimation::timesOf(std::size_t i, bool steps) const {
  std::set<double> times;
  for (std::optional<std::size_t> node = i; node; node = nodes_[*node].parent)
    for (const Channel& channel : channels_[*node])
      if (!steps || channel.track.interpolation == KeyInterpolation::kStep)
        times.insert(channel.track.times.begin(), channel.track.times.end());
  return {times.begin(), times.end()};
}

std::vector<double> GltfAnimation::keyTimes(std::size_t i) const {
  return timesOf(i, false);
}

std::vector<double> GltfAnimation::stepTimes(std::size_t i) const {
  return timesOf(i, true);
}

}  // namespace saccade
