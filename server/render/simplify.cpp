#include "render/simplify.h"

#include <utility>

#include "render/parts/parts.h"
#include "scene/files/text.h"

namespace saccade {
namespace {

void eraseUnusedTextures(Scene& scene) {
  std::vector<Texture> used;
  std::vector<int> index(scene.textures.size(), -1);
  for (Material& m : scene.materials) {
    for (SurfaceColor* c : {&m.reflectance, &m.specular, &m.transmittance, &m.opacity, &m.height}) {
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

const std::vector<PartInfo>& partTable() {
  static const std::vector<PartInfo> table{
      {Part::kTextures, "textures", "colours are the mean of their picture", hasTextures, leaveOutTextures},
      {Part::kSpecular, "specular",
       "plastics and metals are diffuse, of their albedo at a right angle; no glass", hasSpecular,
       leaveOutSpecular},
      {Part::kBumpMaps, "bump_maps", "surfaces are as smooth as their meshes", hasBumpMaps, leaveOutBumpMaps},
      {Part::kMasks, "masks", "what is masked is opaque, or gone where less than half of it is", hasMasks,
       leaveOutMasks},
      {Part::kEnvironment, "environment", "all directions are as bright as their mean", hasEnvironmentPicture,
       leaveOutEnvironmentPicture},
      // Last: what makes textures makes mips for them.
      {Part::kMipFiltering, "mip_filtering", "pictures are looked up at one point", hasMips, leaveOutMips},
  };
  return table;
}

const PartInfo* findPart(const std::string& name) {
  for (const PartInfo& info : partTable())
    if (info.name == name) return &info;
  return nullptr;
}

std::string partNames() {
  std::vector<std::string> names;
  for (const PartInfo& info : partTable()) names.push_back(info.name);
  return joinNames(names);
}

Parts partsOf(const Scene& scene) {
  Parts parts;
  for (const PartInfo& info : partTable())
    if (info.isIn(scene)) parts.insert(info.part);
  return parts;
}

std::vector<std::string> namesOf(const Parts& parts) {
  std::vector<std::string> names;
  for (const PartInfo& info : partTable())
    if (parts.count(info.part)) names.push_back(info.name);
  return names;
}

Scene simplified(Scene scene, const Parts& without) {
  for (const PartInfo& info : partTable())
    if (without.count(info.part)) info.leaveOut(scene);
  eraseUnusedTextures(scene);
  return scene;
}

}  // namespace saccade
