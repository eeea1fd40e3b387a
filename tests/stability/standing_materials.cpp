#include "stability/standing.h"

namespace saccade::test {
namespace {

std::string twosided(const std::string& bsdf) {
  return "<bsdf type='twosided'>" + bsdf + "</bsdf>";
}
std::string bsdf(const std::string& type, const std::string& inside = {}) {
  return "<bsdf type='" + type + "'>" + inside + "</bsdf>";
}
std::string rough(const std::string& type, double alpha, const std::string& microfacets) {
  return twosided(bsdf(type, "<float name='alpha' value='" + std::to_string(alpha) +
                                 "'/><string name='distribution' value='" + microfacets + "'/>"));
}
std::string picture(const std::string& as) {
  return "<texture type='bitmap'" + (as.empty() ? "" : " name='" + as + "'") +
         "><string name='filename' value='flag.ppm'/></texture>";
}
std::string checkerboard(const std::string& as) {
  return "<texture type='checkerboard' name='" + as + "'/>";
}

// Walls, a lamp, and a ball and a plate of the material.
std::string roomWith(const std::string& material) {
  const std::string white = twosided(bsdf("diffuse", checkerboard("reflectance")));
  return "<scene version='3.0.0'><sensor type='perspective'><float name='fov' value='60'/>"
         "<transform name='to_world'><translate z='-1.8'/></transform></sensor>"
         "<shape type='cube'><transform name='to_world'><scale value='2'/></transform>" +
         white +
         "</shape><shape type='sphere'><float name='radius' value='0.5'/>"
         "<transform name='to_world'><translate x='0.4' y='0.3' z='0.4'/></transform>" +
         material +
         "</shape><shape type='rectangle'><transform name='to_world'><scale value='0.7'/>"
         "<rotate y='1' angle='160'/><translate x='-0.7' y='-0.2' z='0.5'/></transform>" +
         material +
         "</shape><shape type='rectangle'><transform name='to_world'><scale value='0.4'/>"
         "<rotate x='1' angle='90'/><translate y='1.9'/></transform>"
         "<emitter type='area'><float name='radiance' value='12'/></emitter></shape></scene>";
}

}  // namespace

std::vector<MaterialScene> materialScenes() {
  std::vector<MaterialScene> all;
  const auto add = [&](const std::string& name, const std::string& material) {
    all.push_back({name, roomWith(material)});
  };
  const std::string diffuse = bsdf("diffuse");
  add("diffuse", twosided(diffuse));
  add("diffuse_black", twosided(bsdf("diffuse", "<float name='reflectance' value='0'/>")));
  add("diffuse_picture", twosided(bsdf("diffuse", picture("reflectance"))));
  add("plastic", twosided(bsdf("plastic")));
  add("conductor", twosided(bsdf("conductor")));
  add("phong", twosided(bsdf("phong", picture("specular_reflectance"))));
  add("ward", twosided(bsdf("ward")));
  for (const char* inner : {"diffuse", "conductor", "roughconductor"})
    add(std::string("coating_") + inner, twosided(bsdf("coating", bsdf(inner))));
  add("roughcoating_roughconductor", twosided(bsdf("roughcoating", bsdf("roughconductor"))));
  add("dielectric", bsdf("dielectric"));
  add("thindielectric", bsdf("thindielectric"));
  add("roughdielectric", bsdf("roughdielectric", "<float name='alpha' value='0.2'/>"));
  for (const std::string microfacets : {"beckmann", "ggx"})
    for (const double alpha : {0.02, 0.05, 0.3, 1.0}) {
      const std::string kind = "_" + microfacets + "_" + std::to_string(static_cast<int>(alpha * 100));
      add("roughconductor" + kind, rough("roughconductor", alpha, microfacets));
      add("roughplastic" + kind, rough("roughplastic", alpha, microfacets));
    }
  for (const char* metallic : {"0", "1"})
    add(std::string("metallicroughness_") + metallic,
        twosided(bsdf("metallicroughness", checkerboard("base_color") +
                                               "<float name='roughness' value='0.3'/>"
                                               "<float name='metallic' value='" +
                                               std::string(metallic) + "'/>")));
  add("roughconductor_picture", twosided(bsdf("roughconductor", picture("specular_reflectance"))));
  for (const std::string& inner : {diffuse, bsdf("roughconductor")}) {
    const std::string of = inner == diffuse ? "diffuse" : "roughconductor";
    add("mask_half_" + of, twosided(bsdf("mask", "<float name='opacity' value='0.5'/>" + inner)));
    add("mask_picture_" + of, twosided(bsdf("mask", picture("opacity") + inner)));
    add("bumpmap_" + of, twosided(bsdf("bumpmap", picture("") + inner)));
  }
  return all;
}

}  // namespace saccade::test
