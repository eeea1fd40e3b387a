#include "render/features/simplify.h"

#include <utility>

#include "base/names.h"
#include "render/features/features.h"

namespace saccade {
namespace {

void eraseUnusedTextures(Scene& scene) {
  std::vector<Texture> used;
  std::vector<int> index(scene.textures.size(), -1);
  for (Material& m : scene.materials) {
    for (SurfaceColor* c : {&m.reflectance, &m.specular, &m.transmittance, &m.metallic_roughness, &m.opacity,
                            &m.emission, &m.height, &m.normals}) {
      if (c->kind != SurfaceColor::Kind::kBitmap) continue;
      const auto old = static_cast<std::size_t>(c->texture);
      if (index[old] < 0) {
        index[old] = static_cast<int>(used.size());
        used.push_back(std::move(scene.textures[old]));
      }
      c->texture = index[old];
    }
  }
  scene.textures = std::move(used);
}

}  // namespace

const std::vector<SceneFeatureInfo>& featureTable() {
  static const std::vector<SceneFeatureInfo> table{
      {SceneFeature::kTextures, "textures", "each picture or checkerboard is its mean colour", hasTextures,
       leaveOutTextures},
      {SceneFeature::kSpecular, "specular",
       "plastics and metals are diffuse, with their albedo at a right angle; no glass", hasSpecular,
       leaveOutSpecular},
      {SceneFeature::kBumpMaps, "bump_maps", "surfaces are as smooth as their meshes", hasBumpMaps,
       leaveOutBumpMaps},
      {SceneFeature::kMasks, "masks",
       "a masked surface is opaque, or gone if its mean opacity is below a half", hasMasks, leaveOutMasks},
      {SceneFeature::kEnvironment, "environment", "all directions are as bright as their mean",
       hasEnvironmentPicture, leaveOutEnvironmentPicture},
      // This is the last one, because other features make new textures with mips.
      {SceneFeature::kMipFiltering, "mip_filtering",
       "pictures are read at one point, however small they are seen", hasMips, leaveOutMips},
  };
  return table;
}

const SceneFeatureInfo* findFeature(const std::string& name) {
  return findRow(featureTable(), name);
}

std::string featureNames() {
  return joinRowNames(featureTable());
}

SceneFeatures featuresOf(const Scene& scene) {
  SceneFeatures parts;
  for (const SceneFeatureInfo& info : featureTable())
    if (info.isIn(scene)) parts.insert(info.feature);
  return parts;
}

std::vector<std::string> namesOf(const SceneFeatures& parts) {
  std::vector<std::string> names;
  for (const SceneFeatureInfo& info : featureTable())
    if (parts.count(info.feature)) names.push_back(info.name);
  return names;
}

Scene simplified(Scene scene, const SceneFeatures& disabled) {
  for (const SceneFeatureInfo& info : featureTable())
    if (disabled.count(info.feature)) info.leaveOut(scene);
  eraseUnusedTextures(scene);
  return scene;
}

}  // namespace saccade
