#include "scene/gltf/gltf_forms.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/gltf/draco_mesh.h"
#include "scene/gltf/gltf_motions.h"
#include "scene/gltf/gltf_primitive.h"
#include "scene/mesh/mesh.h"
#include "scene/shape_box.h"

namespace saccade {
namespace {

constexpr std::size_t kMostJoints = std::numeric_limits<std::uint16_t>::max();
constexpr float kReturns = 1e-3f;  // of its size: so far a vertex may be from where it began

bool isNear(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  ShapeBox box;
  float farthest = 0;
  for (std::size_t i = 0; i + 1 < a.size(); ++i)  // the last is spare
    box.add(a[i]), farthest = std::max(farthest, length(a[i] - b[i]));
  return farthest <= kReturns * length(box.high - box.low);
}

bool isBounded(const MeshForm& form) {
  constexpr float kMost = 1e9f;
  const auto isOne = [](const JointMap& map) {
    return std::ranges::all_of(map, [](float v) { return std::abs(v) <= kMost; });
  };
  return std::ranges::all_of(form.joints, isOne);
}

// Whether a part of the mesh of a node emits light.
bool emits(const JsonNode& root, const JsonNode& node) {
  const auto mesh = node.index("mesh", root.count("meshes"));
  if (!mesh) return false;
  const std::vector<JsonNode> parts = root.entry("meshes", *mesh).list("primitives");
  return std::ranges::any_of(parts, [&](const JsonNode& part) {
    const auto material = part.index("material", root.count("materials"));
    if (!material) return false;
    const auto [r, g, b] = root.entry("materials", *material).numbers<3>("emissiveFactor", {0, 0, 0});
    return r + g + b > 0;
  });
}

}  // namespace

GltfForms::GltfForms(const JsonNode& root, const GltfBuffers* buffers, const std::vector<GltfNode>& nodes,
                     const GltfAnimation& animation, Scene& scene)
    : root_(root),
      buffers_(buffers),
      nodes_(nodes),
      animation_(animation),
      scene_(scene),
      listed_(root.count("nodes")),
      moving_(nodes.size()) {
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    listed_[nodes[i].index] = i;
    const auto mover = animation.moverOf(i);
    if (mover && emits(root, nodes[i].json)) lamps_.insert(*mover);
  }
}

std::vector<std::size_t> GltfForms::jointsOf(std::size_t skin) const {
  const JsonNode json = root_.entry("skins", skin);
  std::vector<std::size_t> joints;
  for (const JsonNode& joint : json.list("joints")) {
    const auto listed = listed_[joint.index(listed_.size())];
    if (!listed) throw joint.error("is not a node of the scene");
    joints.push_back(*listed);
  }
  if (joints.empty() || joints.size() > kMostJoints)
    throw json.error("has " + std::to_string(joints.size()) + " joints; a skin has 1 to " +
                     std::to_string(kMostJoints));
  return joints;
}

// The weights of a node come before those of its mesh.
std::vector<double> GltfForms::weightsOf(const JsonNode& node) const {
  const JsonNode mesh = root_.entry("meshes", node.at("mesh").index(root_.count("meshes")));
  const std::size_t count = targetCount(mesh);
  for (const JsonNode* json : {&node, &mesh})
    if (const auto given = json->find("weights")) return given->numbers(count);
  return std::vector<double>(count);
}

bool GltfForms::staysRigid(std::size_t node) {
  const auto mover = animation_.moverOf(node);
  if (!mover || lamps_.contains(*mover)) return true;
  const auto [found, is_new] = rigid_.try_emplace(*mover, true);
  if (is_new) found->second = saccade::staysRigid(animation_, *mover);
  return found->second;
}

std::optional<GltfForm> GltfForms::of(std::size_t node) {
  const JsonNode& json = nodes_[node].json;
  GltfForm form{node, json.index("skin", root_.count("skins")), {}, {}, animation_.morphs(node)};
  if (form.skin)
    form.joint_nodes = jointsOf(*form.skin);
  else if (!staysRigid(node))
    form.joint = node, form.joint_nodes = {node};
  for (const std::size_t joint : form.joint_nodes)
    form.changes = form.changes || animation_.moverOf(joint).has_value();
  if (form.changes && emits(root_, json)) {
    scene_.unread.push_back("the lamp " + nodes_[node].name + " keeps the form that it has at first");
    form.changes = false;
  }
  const bool has_targets = !weightsOf(json).empty();
  return form.changes || form.skin || has_targets ? std::optional(form) : std::nullopt;
}

void GltfForms::addNodes(const std::vector<GltfForm>& forms) {
  std::vector<bool> needed(nodes_.size());
  for (const GltfForm& form : forms)
    for (std::optional<std::size_t> node : form.joint_nodes)
      for (; node && !needed[*node]; node = nodes_[*node].parent) needed[*node] = true;
  if (std::ranges::find(needed, true) == needed.end()) return;
  MovingNode& ground = scene_.nodes.emplace_back();
  ground.rest.translation = -scene_.origin;
  for (std::size_t i = 0; i < nodes_.size(); ++i) {
    if (!needed[i]) continue;
    moving_[i] = scene_.nodes.size();
    const auto parent = nodes_[i].parent;
    scene_.nodes.push_back(animation_.movingNode(i, parent ? moving_[*parent] : 0));
  }
}

std::vector<Joint> GltfForms::readJoints(const GltfForm& form, const Affine& to_scene) const {
  if (form.joint) return {{moving_[*form.joint], {}}};
  if (!form.skin) return {{{}, to_scene}};
  const std::vector<Affine> binds = readBinds(root_, *buffers_, *form.skin, form.joint_nodes.size());
  std::vector<Joint> joints;
  for (std::size_t i = 0; i < binds.size(); ++i) joints.push_back({moving_[form.joint_nodes[i]], binds[i]});
  return joints;
}

// Decodes a mesh that is compressed once more.
ReadFours GltfForms::foursOf(const JsonNode& part, std::size_t vertices) const {
  if (const auto coded = part.extension("KHR_draco_mesh_compression"))
    return [mesh = std::make_shared<DracoMesh>(*coded, *buffers_)](const std::string& name) {
      return mesh->fours(name);
    };
  return [this, attributes = part.at("attributes"), vertices](const std::string& name) {
    return readAttribute(root_, *buffers_, attributes, name, 4, vertices);
  };
}

Deformation GltfForms::place(const GltfForm& form, const JsonNode& part, const Affine& to_scene,
                             Mesh& mesh) const {
  Deformation d;
  d.positions = mesh.positions, d.normals = mesh.normals;
  d.targets = readTargets(root_, *buffers_, part, mesh);
  if (!d.targets.empty()) d.weights = weightsOf(nodes_[form.node].json);
  if (!d.targets.empty() && animation_.morphs(form.node)) d.weight_keys = animation_.weightKeys(form.node);
  if (d.targets.size() != d.weights.size())
    throw part.error("has another number of targets than other parts of its mesh");
  d.joints = readJoints(form, to_scene);
  if (form.skin)
    d.influences =
        readInfluences(part, foursOf(part, mesh.positions.size()), mesh.positions.size(), d.joints.size());
  NodePoses poses(scene_.nodes);
  MeshForm first, last;
  setForm(d, poses, TimeNs{0}, first);
  if (!isBounded(first)) throw SceneError("a joint is too far away for float numbers");
  deform(d, first, mesh.positions, mesh.normals);
  if (mesh.normals.empty() && isMirrored(first)) turnRound(mesh);
  placeMesh(mesh, {}, mesh.normals.empty());
  const TimeNs length{std::llround(animation_.length() * 1e9)};
  setForm(d, poses, length, last);
  std::vector<Vec3> ends(mesh.positions.size()), normals(mesh.normals.size());
  deform(d, last, ends, normals);
  if (isNear(mesh.positions, ends)) d.period = length;
  return d;
}

}  // namespace saccade
