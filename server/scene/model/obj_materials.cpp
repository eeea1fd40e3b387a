#include "scene/model/obj_materials.h"

#include <algorithm>
#include <filesystem>
#include <utility>

#include "base/names.h"
#include "base/text_cut.h"
#include "scene/files/confinement.h"
#include "scene/files/limits.h"
#include "scene/files/plain_file.h"
#include "scene/files/scene_error.h"
#include "scene/model/mtl_material.h"

namespace saccade {

namespace fs = std::filesystem;

Material greyMaterial() {
  Material grey;
  grey.name = "default";
  grey.twosided = true;
  grey.reflectance = constantColor({0.5f, 0.5f, 0.5f});
  return grey;
}

ObjMaterials::ObjMaterials(const std::string& path, const ObjFile& file, const LoadOptions& options) {
  std::set<std::string> read;
  for (std::string library : file.libraries) {
    if (!read.insert(library).second) continue;
    if (read.size() > kMaxMtlFiles)
      throw SceneError(path + ": more than " + std::to_string(kMaxMtlFiles) + " files of materials");
    std::replace(library.begin(), library.end(), '\\', '/');
    const fs::path folder = fs::path(path).parent_path(), given = folder / library;
    std::error_code absent;
    const bool there = mayRead(given, options.confined_to) && fs::exists(given, absent);
    readLibrary((there ? given : folder / given.filename()).string(), options);
  }
  std::size_t begin = 0;
  int material = file.uses.empty() || file.uses[0].triangle > 0 ? numberOf("") : 0;
  for (const ObjFile::Use& use : file.uses) {
    ranges_.push_back({begin, use.triangle, material});
    begin = use.triangle;
    material = numberOf(use.material);
  }
  ranges_.push_back({begin, file.mesh.triangles.size(), material});
  if (used_.size() > kMaxObjMaterials)
    throw SceneError(path + ": more than " + std::to_string(kMaxObjMaterials) + " materials");
}

void ObjMaterials::readLibrary(const std::string& path, const LoadOptions& options) {
  if (!mayRead(path, options.confined_to)) throw SceneError(path + ": leads out of the folder of the scenes");
  std::error_code fault;
  if (!fs::exists(path, fault)) {
    told_.push_back(path + " is absent: its materials are grey");
    return;
  }
  MtlFile file = parseMtl(readFile(path, kMaxMtlBytes), path);
  if (!file.unread.empty()) told_.push_back(path + ": not read: " + joinNames(file.unread));
  for (MtlMaterial& material : file.materials) {
    const std::string name = material.name;
    known_.try_emplace(name, Named{std::move(material), path});
  }
}

int ObjMaterials::numberOf(const std::string& name) {
  const auto [found, added] = numbers_.try_emplace(name, static_cast<int>(used_.size()));
  if (added) used_.push_back(name);
  return found->second;
}

void ObjMaterials::addTo(Scene& scene, const LoadOptions& options) const {
  MtlPictures pictures(scene, options);
  std::vector<std::string> unknown;
  for (const std::string& name : used_) {
    const auto found = known_.find(name);
    if (found == known_.end() && !name.empty()) unknown.push_back(name);
    scene.materials.push_back(found == known_.end()
                                  ? greyMaterial()
                                  : materialOf(found->second.material, found->second.path, pictures));
  }
  for (Mesh& mesh : scene.meshes) {
    const auto found = known_.find(used_[static_cast<std::size_t>(mesh.material)]);
    if (found != known_.end()) mesh.radiance = found->second.material.emission;
  }
  scene.unread.insert(scene.unread.end(), told_.begin(), told_.end());
  if (!unknown.empty())
    scene.unread.push_back("no file of materials has these, which are grey: " +
                           cutText(joinNames(unknown), kMostNames));
  pictures.read();
}

}  // namespace saccade
