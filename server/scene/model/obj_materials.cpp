#include "scene/model/obj_materials.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

#include "base/names.h"
#include "base/text_cut.h"
#include "scene/files/confinement.h"
#include "scene/files/file_loads.h"
#include "scene/files/find_file.h"
#include "scene/files/limits.h"
#include "scene/files/plain_file.h"
#include "scene/files/scene_error.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMaxMtlBytes = std::size_t{16} << 20;

// Adds pictures to the textures of a scene, one for each file.
class Pictures {
 public:
  Pictures(Scene& scene, const LoadOptions& options) : scene_(scene), options_(options) {}

  SurfaceColor add(const std::string& mtl, const MtlMaterial::Map& map, PixelUse use) {
    const FileLoads::Locate told = [mtl, line = map.line](const std::string& what) {
      return SceneError(mtl, line, what);
    };
    SurfaceColor color;
    color.kind = SurfaceColor::Kind::kBitmap;
    color.texture = numberOf(locate(mtl, map, told), use, told);
    return color;
  }

  void read() { loads_.run(options_); }

 private:
  std::string locate(const std::string& mtl, const MtlMaterial::Map& map,
                     const FileLoads::Locate& told) const {
    try {
      return findFile(map.file, fs::path(mtl).parent_path(), options_);
    } catch (const SceneError& fault) {
      throw told(fault.what());
    }
  }

  int numberOf(const std::string& path, PixelUse use, const FileLoads::Locate& told) {
    const std::size_t next = scene_.textures.size();
    const auto [found, added] = numbers_.try_emplace({path, use}, static_cast<int>(next));
    if (!added) return found->second;
    scene_.textures.push_back(Texture(1, 1, {Rgb{}}));
    loads_.add(told, [this, next, path, use] {
      loads_.takePixels(countPixels(path));
      scene_.textures[next] = loadTexture(path, use);
    });
    return found->second;
  }

  Scene& scene_;
  const LoadOptions& options_;
  FileLoads loads_;
  std::map<std::pair<std::string, PixelUse>, int> numbers_;
};

Material materialOf(const MtlMaterial& mtl, const std::string& path, Pictures& pictures) {
  Material m;
  m.name = mtl.name;
  m.twosided = true;
  m.reflectance = mtl.diffuse_map.file.empty() ? constantColor(mtl.diffuse)
                                               : pictures.add(path, mtl.diffuse_map, PixelUse::kReflectance);
  m.opacity = mtl.opacity_map.file.empty() ? constantColor({mtl.opacity, mtl.opacity, mtl.opacity})
                                           : pictures.add(path, mtl.opacity_map, PixelUse::kOpacity);
  if (luminance(mtl.specular) == 0 || mtl.shininess == 0) return m;
  m.model.kind = BsdfKind::kRoughPlastic;
  m.model.alpha = std::sqrt(2 / (mtl.shininess + 2));  // the same width of highlight [Walter et al. 2007]
  m.specular = constantColor(mtl.specular);
  return m;
}

}  // namespace

Material greyMaterial() {
  Material grey;
  grey.name = "default";
  grey.twosided = true;
  grey.reflectance = constantColor({0.5f, 0.5f, 0.5f});
  return grey;
}

ObjMaterials::ObjMaterials(const std::string& path, const ObjFile& file, const LoadOptions& options) {
  for (std::string library : file.libraries) {
    std::replace(library.begin(), library.end(), '\\', '/');
    readLibrary((fs::path(path).parent_path() / library).string(), options);
  }
  std::size_t begin = 0;
  int material = file.uses.empty() || file.uses[0].triangle > 0 ? numberOf("") : 0;
  for (const ObjFile::Use& use : file.uses) {
    ranges_.push_back({begin, use.triangle, material});
    begin = use.triangle;
    material = numberOf(use.material);
  }
  ranges_.push_back({begin, file.mesh.triangles.size(), material});
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
  Pictures pictures(scene, options);
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
