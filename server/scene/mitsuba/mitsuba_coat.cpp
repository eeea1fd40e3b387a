#include "scene/mitsuba/mitsuba_coat.h"

#include <limits>

namespace saccade {
namespace {

void coatDiffuse(BsdfSource& coat, bool rough, Material& material) {
  material.model.kind = rough ? BsdfKind::kRoughPlastic : BsdfKind::kPlastic;
  material.model.scatters_once = true;
  if (rough) readRoughness(coat, material.model);
  material.model.ior = readIor(coat, kGlass);
  material.specular = coat.textures.readColor(coat.properties, "specular_reflectance", kWhite);
}

void coatConductor(BsdfSource& coat, Material& material) {
  material.model.coat_ior = readIor(coat, kGlass);
  coat.properties.neutral("specular_reflectance", 1);
}

void coatRoughConductor(BsdfSource& coat, bool rough, Material& material) {
  material.model.kind = BsdfKind::kCoatedConductor;
  if (rough) {
    BsdfModel layer;
    readRoughness(coat, layer);
    material.model.coat_alpha = layer.alpha, material.model.coat_microfacets = layer.microfacets;
  }
  coatConductor(coat, material);
  if (material.model.coat_ior < 1)
    throw coat.error("the int_ior of a coat over roughconductor must be at least its ext_ior");
}

}  // namespace

bool isCoat(const std::string& type) {
  return type == "coating" || type == "roughcoating";
}

// Light passes the coat down and up once, as in Mitsuba. Light that the coat sends back down is lost.
void readCoat(BsdfSource coat, Material& material) {
  constexpr float kMost = std::numeric_limits<float>::max();
  const bool rough = std::string_view(coat.bsdf.attribute("type").value()) == "roughcoating";
  coat.properties.object("bsdf");
  coat.properties.number("thickness", 1);
  if (coat.properties.quantity("sigma_a", kMost).value_or(Rgb{}) != Rgb{})
    throw coat.error("a coat that absorbs light is not supported; supported: a sigma_a of 0");
  if (material.model.kind == BsdfKind::kDiffuse)
    coatDiffuse(coat, rough, material);
  else if (material.model.kind == BsdfKind::kConductor && !rough)
    coatConductor(coat, material);
  else if (material.model.kind == BsdfKind::kRoughConductor)
    coatRoughConductor(coat, rough, material);
  else
    throw coat.error(
        "a " + std::string(rough ? "roughcoating" : "coating") + " over " +
        traitsOf(material.model.kind).name +
        " is not supported; supported: coating over diffuse, conductor and roughconductor, "
        "roughcoating over diffuse and roughconductor; leave out the coat, or take one of these");
  coat.properties.finish();
}

}  // namespace saccade
