// The materials of a Mitsuba scene file.
#pragma once

#include <map>
#include <utility>

#include "scene/scene.h"
#include "scene/xml_file.h"

namespace saccade {

class MaterialReader {
 public:
  // Adds what it reads to the materials and textures of `scene`.
  MaterialReader(const XmlFile& file, Scene& scene) : file_(file), scene_(scene) {}

  // Index of the material a <bsdf> describes; of a grey 0.5 if it is null. Each is read once. Throws
  // SceneError.
  int read(pugi::xml_node bsdf);

 private:
  Material parse(pugi::xml_node bsdf);
  Reflectance parseReflectance(pugi::xml_node diffuse);
  Reflectance parseTexture(pugi::xml_node texture);
  int readBitmap(pugi::xml_node at, const std::string& filename, bool raw);

  const XmlFile& file_;
  Scene& scene_;
  std::map<pugi::xml_node, int> materials_;
  std::map<std::pair<std::string, bool>, int> textures_;  // by path and `raw`
};

}  // namespace saccade
