#include "scene/gltf/gltf.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include "base/text_cut.h"
#include "scene/default_view.h"
#include "scene/gltf/gltf_cameras.h"
#include "scene/gltf/gltf_extensions.h"
#include "scene/gltf/gltf_lights.h"
#include "scene/gltf/gltf_meshes.h"
#include "scene/gltf/gltf_motions.h"
#include "scene/gltf/gltf_sky.h"
#include "scene/motion/own_motions.h"
#include "scene/scene_origin.h"
#include "scene/sky/sky_file.h"

namespace saccade {
namespace {

constexpr std::size_t kMaxSentence = 300;  // bytes

// The first of these sentences, once each.
std::vector<std::string> shortened(const std::vector<std::string>& unread) {
  constexpr std::size_t kMost = 24;
  std::vector<std::string> told;
  std::set<std::string> seen;
  for (const std::string& sentence : unread)
    if (seen.insert(sentence).second && told.size() < kMost) told.push_back(cutText(sentence, kMaxSentence));
  if (seen.size() > kMost)
    told.push_back(std::to_string(seen.size() - kMost) + " more things of this kind are not shown");
  return told;
}

Affine relativeTo(Affine to_world, Vec3d origin) {
  to_world.translation = to_world.translation - origin;
  return to_world;
}

// Reads one scene from a file. Without `buffers` it is an outline.
class SceneReader {
 public:
  SceneReader(const GltfFile& file, const GltfBuffers* buffers, const LoadOptions& options, Scene& scene)
      : root_(file.root()),
        nodes_(readNodes(root_)),
        animation_(root_, nodes_, chosenAnimation(file.path(), options)),
        pictures_(file, buffers, loads_, scene),
        materials_(root_, pictures_, scene),
        forms_(root_, buffers, nodes_, animation_, scene),
        meshes_(root_, buffers, materials_, forms_, loads_, scene),
        scene_(scene) {
    if (!addSkyFile(file.path(), options, loads_, scene_)) addSky(file, loads_, scene_);
    if (buffers) animation_.readKeys(*buffers);
  }

  void readNodesOfScene() {
    std::vector<GltfForm> forms;
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      const auto mover = animation_.moverOf(i);
      const Affine to_world = animation_.worldAt(i, 0);
      addLamp(i, mover, to_world);
      if (!nodes_[i].json.find("mesh")) continue;
      auto form = forms_.of(i);
      const bool has_skin = form && form->skin, changes = form && form->changes;
      const std::size_t body = has_skin ? i : mover.value_or(i);
      if (changes || (mover && !has_skin)) movers_.insert(body);
      if (changes && !form->joint_nodes.empty()) deformed_.insert(body);
      if (form) forms.push_back(*form);
      meshes_.add(nodes_[i], {nodes_[body].name, relativeTo(to_world, scene_.origin), std::move(form)});
    }
    forms_.addNodes(forms);
    readCameras(root_, nodes_, animation_, scene_);
    const auto& of_animation = animation_.unread();
    scene_.unread.insert(scene_.unread.end(), of_animation.begin(), of_animation.end());
  }

  void load(const LoadOptions& options) {
    loads_.run(options);
    materials_.setEmission();
    for (const std::size_t i : movers()) addMotion(i);
    sortMotions();
  }

  void nameMotions() {
    for (const std::size_t i : movers()) scene_.motions.push_back({nodes_[i].name, "animation"});
    sortMotions();
  }

 private:
  // A lamp moves with its mover, but not with a skin: there the form moves, not the node.
  void addLamp(std::size_t i, std::optional<std::size_t> mover, const Affine& to_world) {
    const bool of_skin = mover && nodes_[*mover].json.find("skin");
    const std::size_t body = of_skin ? i : mover.value_or(i);
    if (!addLight(root_, nodes_[i].json, {nodes_[body].name, to_world}, scene_) || !mover) return;
    if (of_skin)
      scene_.unread.push_back("the lamp " + nodes_[i].name + " stands where its animation begins");
    else
      movers_.insert(*mover);
  }

  std::vector<std::size_t> movers() {
    std::vector<std::size_t> all(movers_.begin(), movers_.end());
    if (all.size() <= kMostOwnMotions) return all;
    scene_.unread.push_back("the first " + std::to_string(kMostOwnMotions) + " of " +
                            std::to_string(all.size()) + " animated objects move");
    all.resize(kMostOwnMotions);
    return all;
  }

  void addMotion(std::size_t i) {
    const FixedBody body = fixedBody(scene_, nodes_[i].name);
    const OwnMotion stands{body.name, "animation", Trajectory({{TimeNs{0}, {body.centre, {}}}}), 1};
    if (deformed_.contains(i) || !animation_.moverOf(i)) return scene_.motions.push_back(stands);
    if (auto motion = bodyMotion(animation_, i, body, scene_.unread))
      scene_.motions.push_back(std::move(*motion));
    else if (std::ranges::any_of(scene_.meshes, [&](const Mesh& mesh) {
               return mesh.name == body.name && mesh.deformation != kKeepsForm;
             }))
      scene_.motions.push_back(stands);
  }

  void sortMotions() { std::ranges::sort(scene_.motions, {}, &OwnMotion::name); }

  const JsonNode root_;
  const std::vector<GltfNode> nodes_;
  GltfAnimation animation_;
  FileLoads loads_;
  GltfPictures pictures_;
  GltfMaterials materials_;
  GltfForms forms_;
  GltfMeshes meshes_;
  Scene& scene_;
  std::set<std::size_t> movers_;    // nodes with meshes and lamps, by which these move
  std::set<std::size_t> deformed_;  // those of them whose whole motion is a deformation
};

Scene loadAt(const GltfFile& file, const GltfBuffers& buffers, const LoadOptions& options, Vec3d origin) {
  Scene scene;
  scene.name = std::filesystem::path(file.path()).parent_path().filename().string();
  scene.origin = origin;
  scene.unread = unreadExtensions(file.root());
  SceneReader reader(file, &buffers, options, scene);
  reader.readNodesOfScene();
  if (scene.meshes.empty()) throw file.root().error("the scene has no mesh");
  reader.load(options);
  addDefaults(scene);
  scene.unread = shortened(scene.unread);
  return scene;
}

}  // namespace

Scene loadGltf(const std::string& path, const LoadOptions& options) {
  const GltfFile file(path, options);
  const GltfBuffers buffers(file);
  return loadAtOrigin([&](Vec3d origin) { return loadAt(file, buffers, options, origin); });
}

std::vector<std::string> animationsOfGltf(const std::string& path, const LoadOptions& options) {
  return animationNames(GltfFile(path, options).root());
}

Scene outlineGltf(const std::string& path, const LoadOptions& options) {
  const GltfFile file(path, options);
  Scene scene;
  scene.unread = unreadExtensions(file.root());
  SceneReader reader(file, nullptr, options, scene);
  reader.readNodesOfScene();
  if (scene.meshes.empty()) throw file.root().error("the scene has no mesh");
  reader.nameMotions();
  scene.unread = shortened(scene.unread);
  return scene;
}

}  // namespace saccade
