#include "scene/mitsuba/mitsuba_bsdf.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/conductors.h"
#include "scene/mitsuba/mitsuba_gloss.h"

namespace saccade {
namespace {

// Mitsuba 0.6 takes either name.
void readDiffuse(BsdfSource& from, Material& material) {
  const SurfaceColor other = from.textures.readColor(from.properties, "diffuse_reflectance", kHalf);
  material.reflectance = from.textures.readColor(from.properties, "reflectance", other);
}

void readSpecular(BsdfSource& from, Material& material) {
  material.specular = from.textures.readColor(from.properties, "specular_reflectance", kWhite);
}

void readPlastic(BsdfSource& from, Material& material) {
  material.model.ior = readIor(from, "polypropylene");
  material.reflectance = from.textures.readColor(from.properties, "diffuse_reflectance", kHalf);
  material.model.nonlinear = from.properties.flag("nonlinear", false);
  readSpecular(from, material);
}

// A part of a metal's index. Colours outside of Rec. 709 have parts below 0, which become 0.
std::optional<Rgb> readPart(BsdfSource& from, const std::string& name) {
  constexpr float kMax = std::numeric_limits<float>::max();
  std::optional<Rgb> index = from.properties.quantity(name, kMax, -1);
  if (index) index = Rgb{std::max(index->x, 0.f), std::max(index->y, 0.f), std::max(index->z, 0.f)};
  return index;
}

// eta and k, or a metal by name.
void readConductor(BsdfSource& from, Material& material) {
  const auto eta = readPart(from, "eta"), k = readPart(from, "k");
  const std::string name = from.properties.text("material");
  const float outside = static_cast<float>(readIndex(from, "ext_eta", "vacuum"));
  if (eta.has_value() != k.has_value() || (eta && !name.empty()))
    throw from.error("a metal needs eta and k, or <string name=\"material\">, or neither");
  ComplexIndex metal{name, eta.value_or(Rgb{}), k.value_or(Rgb{})};
  if (!eta) {
    const ComplexIndex* found = findConductor(name.empty() ? from.file.isMitsuba0() ? "Cu" : "none" : name);
    if (!found) throw from.error("the metal '" + name + "' is not known; known: " + conductorNames());
    metal = *found;
  }
  material.model.eta = metal.eta / outside;
  material.model.k = metal.k / outside;
  readSpecular(from, material);
}

void readDielectric(BsdfSource& from, Material& material) {
  constexpr float kLeastBend = 1e-3f;  // nearer to 1, microfacets cannot be told from straight on
  material.model.ior = readIor(from, kGlass);
  if (material.model.kind == BsdfKind::kRoughDielectric && std::abs(material.model.ior - 1) < kLeastBend)
    throw from.error("int_ior and ext_ior of rough glass must differ by 0.001 at least");
  material.transmittance = from.textures.readColor(from.properties, "specular_transmittance", kWhite);
  readSpecular(from, material);
}

// Our own, with names as those of Mitsuba's principled.
void readMetallicRoughness(BsdfSource& from, Material& material) {
  material.model.ior = readIor(from, kGlass);
  material.reflectance = from.textures.readColor(from.properties, "base_color", kHalf);
  const double metallic = from.properties.number("metallic", 0),
               roughness = from.properties.number("roughness", 0.5);
  if (!(metallic >= 0 && metallic <= 1 && roughness >= 0 && roughness <= 1))
    throw from.error("metallic and roughness must be within [0, 1]");
  material.metallic_roughness =
      constantColor({0, static_cast<float>(roughness), static_cast<float>(metallic)});
}

// Exporters write these for smooth surfaces too, where Mitsuba does not read them.
void ignoreRoughness(Properties& properties) {
  properties.ignore("string", {"distribution"});
  properties.ignore("float", {"alpha"});
}

void readKind(BsdfKind kind, BsdfSource& from, Material& material) {
  material.model.kind = kind;
  switch (kind) {
    case BsdfKind::kDiffuse:
      return readDiffuse(from, material);
    case BsdfKind::kRoughPlastic:
      readRoughness(from, material.model);
      [[fallthrough]];
    case BsdfKind::kPlastic:
      return readPlastic(from, material);
    case BsdfKind::kRoughConductor:
      readRoughness(from, material.model);
      [[fallthrough]];
    case BsdfKind::kConductor:
      return readConductor(from, material);
    case BsdfKind::kRoughDielectric:
      readRoughness(from, material.model);
      [[fallthrough]];
    case BsdfKind::kDielectric:
    case BsdfKind::kThinDielectric:
      return readDielectric(from, material);
    case BsdfKind::kMetallicRoughness:
      return readMetallicRoughness(from, material);
    case BsdfKind::kPhong:
      return readPhong(from, material);
    case BsdfKind::kWard:
      return readWard(from, material);
    case BsdfKind::kCoatedConductor:  // readCoat() makes it
    case BsdfKind::kCount:
      return;
  }
}

}  // namespace

std::vector<std::string> bsdfTypes() {
  std::vector<std::string> names;
  for (const BsdfTraits& row : kBsdfTraits) names.push_back(row.name);
  names.push_back(kRoughDiffuse);
  return names;
}

void readBsdf(BsdfSource from, Material& material) {
  std::string name = supportedType(from.file, from.bsdf, bsdfTypes());
  if (name == kRoughDiffuse) readRoughDiffuse(from), name = traitsOf(BsdfKind::kDiffuse).name;
  for (const BsdfTraits& row : kBsdfTraits)
    if (row.name == name) readKind(row.kind, from, material);
  if (traitsOf(material.model.kind).delta) ignoreRoughness(from.properties);
  from.properties.finish();
}

}  // namespace saccade
