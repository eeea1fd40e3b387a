#include "scene/gltf/gltf_nodes.h"

#include <set>

#include "scene/files/limits.h"

namespace saccade {
namespace {

Vec3d vec(const std::array<double, 3>& v) {
  return {v[0], v[1], v[2]};
}

// Columns of four numbers, of which the last row is 0 0 0 1.
Affine readMatrix(const JsonNode& node) {
  const std::vector<double> m = node.numbers(16);
  if (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1)
    throw node.error("is not an affine map: its last row must be 0 0 0 1");
  return {{m[0], m[1], m[2]}, {m[4], m[5], m[6]}, {m[8], m[9], m[10]}, {m[12], m[13], m[14]}};
}

LocalTransform readTransform(const JsonNode& node) {
  LocalTransform local;
  if (const auto matrix = node.find("matrix")) {
    local.matrix = readMatrix(*matrix);
    return local;
  }
  local.rotation = readRotation(node);
  local.translation = vec(node.numbers<3>("translation", {0, 0, 0}));
  local.scale = vec(node.numbers<3>("scale", {1, 1, 1}));
  return local;
}

std::vector<std::size_t> indices(const JsonNode& of, const char* key, std::size_t count) {
  std::vector<std::size_t> all;
  for (const JsonNode& entry : of.list(key)) all.push_back(entry.index(count));
  return all;
}

// The nodes without a parent.
std::vector<std::size_t> allRoots(const JsonNode& root) {
  const std::size_t count = root.count("nodes");
  std::vector<bool> child(count);
  for (const JsonNode& node : root.list("nodes"))
    for (const std::size_t i : indices(node, "children", count)) child[i] = true;
  std::vector<std::size_t> roots;
  for (std::size_t i = 0; i < count; ++i)
    if (!child[i]) roots.push_back(i);
  return roots;
}

std::vector<std::size_t> sceneRoots(const JsonNode& root) {
  const auto scene = sceneOf(root);
  return scene ? indices(*scene, "nodes", root.count("nodes")) : allRoots(root);
}

// Names of nodes may be absent, or come twice.
class Names {
 public:
  explicit Names(const JsonNode& root) : root_(root) {}

  std::string of(const JsonNode& node, std::size_t index) {
    std::string name = node.text("name");
    const auto mesh = node.index("mesh", root_.count("meshes"));
    if (name.empty() && mesh) name = root_.entry("meshes", *mesh).text("name");
    if (name.empty()) name = "node " + std::to_string(index);
    if (!taken_.insert(name).second) taken_.insert(name += "@" + std::to_string(index));
    return name;
  }

 private:
  const JsonNode& root_;
  std::set<std::string> taken_;
};

}  // namespace

std::optional<JsonNode> sceneOf(const JsonNode& root) {
  const std::size_t scenes = root.count("scenes");
  if (scenes == 0) return {};
  return root.entry("scenes", root.index("scene", scenes).value_or(0));
}

Quaternion readRotation(const JsonNode& json) {
  const auto [x, y, z, w] = json.numbers<4>("rotation", {0, 0, 0, 1});
  if (!isRotation({x, y, z, w})) throw json.error("the rotation has no length");
  return normalize(Quaternion{x, y, z, w});
}

std::vector<GltfNode> readNodes(const JsonNode& root) {
  struct Visit {
    std::size_t index;
    std::optional<std::size_t> parent;
    int depth;
  };
  const std::size_t count = root.count("nodes");
  std::vector<Visit> open;
  const auto push = [&](const std::vector<std::size_t>& found, std::optional<std::size_t> parent, int depth) {
    for (auto i = found.rbegin(); i != found.rend(); ++i) open.push_back({*i, parent, depth});
  };
  push(sceneRoots(root), {}, 1);
  Names names(root);
  std::vector<bool> seen(count);
  std::vector<GltfNode> nodes;
  while (!open.empty()) {
    const Visit visit = open.back();
    open.pop_back();
    const JsonNode node = root.entry("nodes", visit.index);
    if (seen[visit.index]) throw node.error("stands in the scene twice; nodes are a tree");
    if (visit.depth > kMaxNodeDepth)
      throw node.error("the nodes are nested more than " + std::to_string(kMaxNodeDepth) + " deep");
    seen[visit.index] = true;
    nodes.push_back({visit.index, node, visit.parent, names.of(node, visit.index), readTransform(node)});
    push(indices(node, "children", count), nodes.size() - 1, visit.depth + 1);
  }
  return nodes;
}

}  // namespace saccade
