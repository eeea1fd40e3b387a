// Meshes of a glTF file that change their form, by skins, morph targets, and nodes that change their size.
#pragma once

#include <map>
#include <set>

#include "scene/gltf/form_data.h"
#include "scene/gltf/gltf_animation.h"
#include "scene/scene.h"

namespace saccade {

// Of the mesh of a node.
struct GltfForm {
  std::size_t node;                      // of the list
  std::optional<std::size_t> skin;       // of the file
  std::optional<std::size_t> joint;      // without a skin: the node whose motion deforms the mesh
  std::vector<std::size_t> joint_nodes;  // of the list: those of the skin, or the joint
  bool changes;                          // over time
};

class GltfForms {
 public:
  // `buffers`: nullptr of an outline.
  GltfForms(const JsonNode& root, const GltfBuffers* buffers, const std::vector<GltfNode>& nodes,
            const GltfAnimation& animation, Scene& scene);

  // None where the mesh has but the form of its vertices. Lamps keep their form, and what moves with a lamp
  // its size. Throws SceneError.
  std::optional<GltfForm> of(std::size_t node);
  // Adds to Scene::nodes all that these forms follow. Before meshes are read.
  void addNodes(const std::vector<GltfForm>& forms);

  // Takes a part of the mesh as it was read, and puts it where it is at stream time 0. `to_scene`: that of
  // its node, at this time. May run on any thread. Throws SceneError.
  Deformation place(const GltfForm& form, const JsonNode& part, const Affine& to_scene, Mesh& mesh) const;

 private:
  bool staysRigid(std::size_t node);
  std::vector<std::size_t> jointsOf(std::size_t skin) const;
  std::vector<Joint> readJoints(const GltfForm& form, const Affine& to_scene) const;
  std::vector<double> weightsOf(const JsonNode& node) const;
  ReadFours foursOf(const JsonNode& part, std::size_t vertices) const;

  const JsonNode root_;
  const GltfBuffers* buffers_;
  const std::vector<GltfNode>& nodes_;
  const GltfAnimation& animation_;
  Scene& scene_;
  std::vector<std::optional<std::size_t>> listed_;  // by index in the file: the place in the list of nodes
  std::set<std::size_t> lamps_;                     // nodes that move meshes that emit
  std::map<std::size_t, bool> rigid_;               // by moving node: whether it keeps its size
  std::vector<std::size_t> moving_;                 // by place in the list: the place in Scene::nodes
};

}  // namespace saccade
