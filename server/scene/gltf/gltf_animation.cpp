#include "scene/gltf/gltf_animation.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "base/names.h"
#include "base/text_cut.h"
#include "scene/gltf/form_data.h"

namespace saccade {
namespace {

constexpr float kMostSeconds = 1e6f;

KeyInterpolation interpolationOf(const JsonNode& sampler) {
  const std::string name = sampler.text("interpolation", "LINEAR");
  if (name == "LINEAR") return KeyInterpolation::kLinear;
  if (name == "STEP") return KeyInterpolation::kStep;
  if (name == "CUBICSPLINE") return KeyInterpolation::kCubic;
  throw sampler.error("the interpolation is not LINEAR, STEP or CUBICSPLINE");
}

// Of a part of a node that is no weight.
NodeTrack::Property propertyOf(const JsonNode& target) {
  using Property = NodeTrack::Property;
  const std::string path = target.at("path").text();
  if (path == "translation") return Property::kTranslation;
  if (path == "rotation") return Property::kRotation;
  if (path == "scale") return Property::kScale;
  throw target.error("path is not translation, rotation, scale or weights");
}

// `components`: numbers of an element of the output; a value is of `size` numbers.
KeyTrack readTrack(const JsonNode& root, const JsonNode& sampler, const GltfBuffers& buffers,
                   std::size_t components, std::size_t size) {
  const std::size_t accessors = root.count("accessors");
  KeyTrack track{interpolationOf(sampler), components == 4, size, {}, {}};
  track.times = readFloats(root, buffers, sampler.at("input").index(accessors), 1);
  track.values = readFloats(root, buffers, sampler.at("output").index(accessors), components);
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

// Of the mesh of a node: at least 1.
std::size_t targetCount(const JsonNode& root, const JsonNode& node) {
  const auto mesh = node.index("mesh", root.count("meshes"));
  if (!mesh) throw node.error("the weights of a node without a mesh are animated");
  const std::size_t count = saccade::targetCount(root.entry("meshes", *mesh));
  if (count == 0) throw node.error("the weights of a mesh without targets are animated");
  return count;
}

}  // namespace

std::vector<std::string> animationNames(const JsonNode& root) {
  std::vector<std::string> names;
  for (const JsonNode& animation : root.list("animations"))
    names.push_back(animation.text("name", "animation " + std::to_string(names.size())));
  return names;
}

GltfAnimation::GltfAnimation(const JsonNode& root, const std::vector<GltfNode>& nodes,
                             const std::optional<ChosenAnimation>& chosen)
    : root_(root),
      nodes_(nodes),
      places_(root.count("nodes")),
      tracks_(nodes.size()),
      samplers_(nodes.size()),
      weights_(nodes.size()) {
  for (std::size_t i = 0; i < nodes.size(); ++i) places_[nodes[i].index] = i;
  const std::vector<JsonNode> animations = root.list("animations");
  const std::vector<std::string> names = animationNames(root);
  if (chosen && std::ranges::find(names, chosen->name) == names.end())
    throw chosen->error("the file has no animation '" + cutText(chosen->name, kMaxEcho) +
                        "'; it has: " + cutText(joinNames(names), kMostNames));
  for (std::size_t i = 0; i < animations.size(); ++i) {
    if (chosen && names[i] != chosen->name) continue;
    const std::vector<JsonNode> channels = animations[i].list("channels");
    if (std::ranges::any_of(channels, [&](const JsonNode& channel) { return isTaken(channel); }))
      unread_.push_back(
          "the animation '" + names[i] +
          "' does not play, as one before it moves the same; --animation or motion.toml may choose it");
    else
      addAnimation(animations[i]);
  }
}

// Whether an animation that plays moves the same part of the same node.
bool GltfAnimation::isTaken(const JsonNode& channel) const {
  const JsonNode target = channel.at("target");
  const auto node = target.index("node", places_.size());
  if (!node || !places_[*node]) return false;
  const std::string path = target.at("path").text();
  if (path == "weights") return weights_[*places_[*node]].has_value();
  return std::ranges::any_of(tracks_[*places_[*node]],
                             [&](const NodeTrack& track) { return propertyOf(target) == track.property; });
}

void GltfAnimation::addAnimation(const JsonNode& animation) {
  for (const JsonNode& channel : animation.list("channels")) {
    if (isTaken(channel)) throw channel.error("has the target of another channel of its animation");
    addChannel(animation, channel);
  }
}

void GltfAnimation::addChannel(const JsonNode& animation, const JsonNode& channel) {
  const JsonNode target = channel.at("target");
  const JsonNode sampler =
      animation.entry("samplers", channel.at("sampler").index(animation.count("samplers")));
  const auto node = target.index("node", places_.size());
  if (!node || !places_[*node]) return;
  const std::size_t i = *places_[*node];
  if (target.at("path").text() == "weights") {
    weights_[i].emplace(WeightTrack{sampler, {}});
    return;
  }
  if (nodes_[i].rest.matrix) throw target.error("a node with a matrix cannot be animated");
  tracks_[i].push_back({propertyOf(target), {}}), samplers_[i].push_back(sampler);
}

void GltfAnimation::readKeys(const GltfBuffers& buffers) {
  const auto read = [&](const JsonNode& sampler, std::size_t components, std::size_t size) {
    KeyTrack keys = readTrack(root_, sampler, buffers, components, size);
    length_ = std::max(length_, static_cast<double>(keys.times.back()));
    return keys;
  };
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    for (std::size_t k = 0; k < tracks_[i].size(); ++k) {
      const std::size_t size = tracks_[i][k].property == NodeTrack::Property::kRotation ? 4 : 3;
      tracks_[i][k].keys = read(samplers_[i][k], size, size);
    }
    if (weights_[i]) weights_[i]->keys = read(weights_[i]->sampler, 1, targetCount(root_, nodes_[i].json));
  }
}

MovingNode GltfAnimation::movingNode(std::size_t i, std::size_t parent) const {
  return {parent, nodes_[i].rest, tracks_[i]};
}

std::optional<std::size_t> GltfAnimation::moverOf(std::size_t i) const {
  std::optional<std::size_t> node = i;
  while (node && tracks_[*node].empty()) node = nodes_[*node].parent;
  return node;
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
    for (const NodeTrack& track : tracks_[*node])
      if (!steps || track.keys.interpolation == KeyInterpolation::kStep)
        times.insert(track.keys.times.begin(), track.keys.times.end());
  return {times.begin(), times.end()};
}

std::vector<double> GltfAnimation::keyTimes(std::size_t i) const {
  return timesOf(i, false);
}

std::vector<double> GltfAnimation::stepTimes(std::size_t i) const {
  return timesOf(i, true);
}

}  // namespace saccade
