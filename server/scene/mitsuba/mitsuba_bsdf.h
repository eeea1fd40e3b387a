// The BSDF at the bottom of a Mitsuba material.
#pragma once

#include "scene/mitsuba/mitsuba_texture.h"

namespace saccade {

// The types of <bsdf> that readBsdf() knows: what "roughplastic" and the like are called.
std::vector<std::string> bsdfTypes();

// Sets what a <bsdf> of one of these types says of a material. Throws SceneError.
void readBsdf(const XmlFile& file, pugi::xml_node bsdf, TextureReader& textures, Material& material);

}  // namespace saccade
