#include "scene/gltf/form_data.h"

#include <algorithm>
#include <cmath>

#include "scene/gltf/gltf_primitive.h"

namespace saccade {
namespace {

constexpr std::size_t kMatrix = 16;
constexpr float kRow = 1e-4f;  // how far the last row of a matrix may be from 0 0 0 1

Affine affineOf(const float* m) {
  const auto column = [&](std::size_t i) { return toDouble(Vec3{m[4 * i], m[4 * i + 1], m[4 * i + 2]}); };
  return {column(0), column(1), column(2), column(3)};
}

bool isAffine(const float* m) {
  for (std::size_t i = 0; i < kMatrix; ++i)
    if (!std::isfinite(m[i])) return false;
  return std::abs(m[3]) + std::abs(m[7]) + std::abs(m[11]) + std::abs(m[15] - 1) <= kRow;
}

std::string nameOf(const char* attribute, std::size_t set) {
  return std::string(attribute) + "_" + std::to_string(set);
}

// Of JOINTS: four joints each.
std::size_t countSets(const JsonNode& part) {
  constexpr std::size_t kMostSets = 4;
  const JsonNode attributes = part.at("attributes");
  std::size_t count = 1;
  while (attributes.find(nameOf("JOINTS", count).c_str())) ++count;
  if (count > kMostSets)
    throw part.error("has more than " + std::to_string(4 * kMostSets) + " joints a vertex");
  return count;
}

Influence influence(const JsonNode& part, const float* numbers, const float* weights, std::size_t joints) {
  Influence read;
  for (std::size_t k = 0; k < 4; ++k) {
    const float weight = read.weights[k] = weights[k], joint = numbers[k];
    if (!(weight >= 0)) throw part.error("a weight of a vertex is below 0");
    if (weight > 0 && !(joint >= 0 && joint < static_cast<float>(joints)))
      throw part.error("a vertex has a joint beyond the " + std::to_string(joints) + " of the skin");
    read.joints[k] = weight > 0 ? static_cast<std::uint16_t>(joint) : std::uint16_t{0};
  }
  return read;
}

// Makes the weights of a vertex sum up to 1.
void normalize(const JsonNode& part, std::span<Influence> influences) {
  float sum = 0;
  for (const Influence& one : influences)
    for (const float weight : one.weights) sum += weight;
  if (!(sum > 0)) throw part.error("all weights of a vertex are 0");
  for (Influence& one : influences)
    for (float& weight : one.weights) weight /= sum;
}

}  // namespace

std::size_t targetCount(const JsonNode& mesh) {
  std::size_t count = 0;
  for (const JsonNode& part : mesh.list("primitives")) count = std::max(count, part.count("targets"));
  return count;
}

std::vector<Affine> readBinds(const JsonNode& root, const GltfBuffers& buffers, std::size_t skin,
                              std::size_t joints) {
  const JsonNode json = root.entry("skins", skin);
  const auto index = json.index("inverseBindMatrices", root.count("accessors"));
  if (!index) return std::vector<Affine>(joints);
  const std::vector<float> numbers = readFloats(root, buffers, *index, kMatrix);
  if (numbers.size() < kMatrix * joints) throw json.error("has fewer inverseBindMatrices than joints");
  std::vector<Affine> binds;
  for (std::size_t i = 0; i < joints; ++i) {
    const float* m = numbers.data() + kMatrix * i;
    if (!isAffine(m)) throw json.error("an inverseBindMatrix is not an affine map");
    binds.push_back(affineOf(m));
  }
  return binds;
}

std::vector<MorphTarget> readTargets(const JsonNode& root, const GltfBuffers& buffers, const JsonNode& part,
                                     const Mesh& mesh) {
  std::vector<MorphTarget> targets;
  const std::size_t vertices = mesh.positions.size();
  for (const JsonNode& target : part.list("targets")) {
    MorphTarget& read = targets.emplace_back();
    read.positions = readVectors(root, buffers, target, "POSITION", vertices);
    read.positions.resize(vertices);
    if (!mesh.normals.empty()) read.normals = readVectors(root, buffers, target, "NORMAL", vertices);
  }
  return targets;
}

std::vector<Influence> readInfluences(const JsonNode& part, const ReadFours& read, std::size_t vertices,
                                      std::size_t joints) {
  const std::size_t sets = countSets(part);
  std::vector<Influence> all(sets * vertices);
  for (std::size_t set = 0; set < sets; ++set) {
    const std::vector<float> numbers = read(nameOf("JOINTS", set)), weights = read(nameOf("WEIGHTS", set));
    if (numbers.empty() || weights.empty()) throw part.error("a skin needs JOINTS_0 and WEIGHTS_0");
    for (std::size_t i = 0; i < vertices; ++i)
      all[sets * i + set] = influence(part, &numbers[4 * i], &weights[4 * i], joints);
  }
  for (std::size_t i = 0; i < vertices; ++i) normalize(part, std::span(all).subspan(sets * i, sets));
  return all;
}

}  // namespace saccade
