// The colours and textures of a Mitsuba scene file.
#pragma once

#include <map>
#include <utility>

#include "scene/files/file_loads.h"
#include "scene/mitsuba/xml_properties.h"
#include "scene/scene.h"

namespace saccade {

// All throw SceneError.
class TextureReader {
 public:
  // Adds pictures to the textures of `scene`, one for each file, which `loads` will read.
  TextureReader(const XmlFile& file, FileLoads& loads, Scene& scene)
      : file_(file), loads_(loads), scene_(scene) {}

  // The meaning of a colour: opacity is the alpha of pictures that have one, and radiance may exceed 1.
  enum class Use { kReflectance, kOpacity, kRadiance };

  // The property called `name`: a number, a colour or a texture.
  SurfaceColor readColor(Properties& properties, const std::string& name, const SurfaceColor& fallback,
                         Use use = Use::kReflectance);
  // Of radiances there are bitmaps alone.
  SurfaceColor readTexture(pugi::xml_node texture, Use use = Use::kReflectance);

 private:
  SurfaceColor readBitmap(pugi::xml_node bitmap, Properties& properties, Use use);
  int addPicture(pugi::xml_node at, const std::string& path, PixelUse use);

  const XmlFile& file_;
  FileLoads& loads_;
  Scene& scene_;
  std::map<std::pair<std::string, PixelUse>, int> pictures_;
};

}  // namespace saccade
