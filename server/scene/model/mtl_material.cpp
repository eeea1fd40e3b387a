#include "scene/model/mtl_material.h"

#include <cmath>
#include <filesystem>

#include "scene/files/find_file.h"

namespace saccade {

SurfaceColor MtlPictures::add(const std::string& mtl, const MtlMaterial::Map& map, PixelUse use) {
  const FileLoads::Locate told = [mtl, line = map.line](const std::string& what) {
    return SceneError(mtl, line, what);
  };
  SurfaceColor color;
  color.kind = SurfaceColor::Kind::kBitmap;
  try {
    const auto folder = std::filesystem::path(mtl).parent_path();
    color.texture = numberOf(findFile(map.file, folder, options_), use, told);
  } catch (const SceneError& fault) {
    throw told(fault.what());
  }
  return color;
}

int MtlPictures::numberOf(const std::string& path, PixelUse use, const FileLoads::Locate& told) {
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

Material materialOf(const MtlMaterial& mtl, const std::string& path, MtlPictures& pictures) {
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

}  // namespace saccade
