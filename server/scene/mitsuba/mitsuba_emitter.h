// The emitters of a Mitsuba scene file that are the surface of a shape.
#pragma once

#include "scene/mitsuba/mitsuba_texture.h"

namespace saccade {

struct Emission {
  Rgb radiance;  // of a picture: 1, until it has been read
  SurfaceColor picture = kWhite;
  Strength strength;
};

// Reads the <emitter type="area"> of a shape. Throws SceneError.
Emission parseEmitter(const XmlFile& file, pugi::xml_node emitter, TextureReader& textures);

// Whether the radiance of an emitter is a texture. Without an emitter it is none.
bool hasTexture(const XmlFile& file, pugi::xml_node emitter);

}  // namespace saccade
