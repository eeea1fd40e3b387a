// The materials of a Mitsuba scene file.
#pragma once

#include <map>

#include "scene/mitsuba/mitsuba_texture.h"

namespace saccade {

class MaterialReader {
 public:
  // Adds what it reads to the materials of `scene`.
  MaterialReader(const XmlFile& file, TextureReader& textures, Scene& scene)
      : file_(file), textures_(textures), scene_(scene) {}

  // The index of the material that a <bsdf> describes; without one, of a grey of 0.5. Each is read once.
  // Throws SceneError.
  int read(pugi::xml_node bsdf);
  // The index of a copy of one of these materials, with this emission.
  int addEmitting(int material, const SurfaceColor& emission);

  TextureReader& textures() { return textures_; }

 private:
  enum class Blends { kRead, kRefused };
  Material parse(pugi::xml_node bsdf, Blends blends = Blends::kRead);
  pugi::xml_node readBlend(const std::string& type, pugi::xml_node bsdf, Material& material);
  pugi::xml_node readWrapper(const std::string& type, pugi::xml_node bsdf, Material& material);

  const XmlFile& file_;
  TextureReader& textures_;
  Scene& scene_;
  std::map<pugi::xml_node, int> materials_;
};

}  // namespace saccade
