// Values that several types of <bsdf> have.
#pragma once

#include "scene/mitsuba/mitsuba_texture.h"

namespace saccade {

// Where a <bsdf> is read from, property by property.
struct BsdfSource {
  BsdfSource(const XmlFile& of, pugi::xml_node node, TextureReader& pictures, std::vector<std::string>& told)
      : file(of), bsdf(node), properties(of, node), textures(pictures), unread(told) {}

  SceneError error(const std::string& what) const { return file.error(bsdf, what); }

  const XmlFile& file;
  pugi::xml_node bsdf;
  Properties properties;
  TextureReader& textures;
  std::vector<std::string>& unread;  // sentences on what is shown otherwise
};

inline constexpr const char* kGlass = "bk7";  // Mitsuba's default inside glass and coats
inline constexpr SurfaceColor kHalf = constantColor({0.5f, 0.5f, 0.5f});

// All throw SceneError.
double readIndex(BsdfSource& from, const std::string& name, const std::string& fallback);  // or its name
float readIor(BsdfSource& from, const std::string& interior_default);  // inside over outside
float readAlpha(BsdfSource& from);                                     // in [0, 1]
void readRoughness(BsdfSource& from, BsdfModel& model);                // alpha and microfacets

}  // namespace saccade
