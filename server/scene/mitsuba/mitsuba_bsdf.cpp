#include "scene/mitsuba/mitsuba_bsdf.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "scene/conductors.h"
#include "scene/dielectrics.h"

namespace saccade {
namespace {

// Mitsuba's defaults.
constexpr const char *kAir = "air", *kGlass = "bk7", *kPolypropylene = "polypropylene";
constexpr SurfaceColor kHalf = constantColor({0.5f, 0.5f, 0.5f});

// One BSDF, property by property.
class BsdfReader {
 public:
  BsdfReader(const XmlFile& file, pugi::xml_node bsdf, TextureReader& textures, Material& material)
      : file_(file), bsdf_(bsdf), properties_(file, bsdf), textures_(textures), material_(material) {}

  void read(BsdfKind kind);

 private:
  void readDiffuse();
  void readPlastic();
  std::optional<Rgb> readIndex(const std::string& name);
  void readConductor();
  void readDielectric();
  void readMetallicRoughness();
  void readRoughness();
  void ignoreRoughness();
  void readIor(const std::string& interior_default);
  double index(const std::string& name, const std::string& fallback);

  const XmlFile& file_;
  pugi::xml_node bsdf_;
  Properties properties_;
  TextureReader& textures_;
  Material& material_;
};

void BsdfReader::read(BsdfKind kind) {
  material_.model.kind = kind;
  switch (kind) {
    case BsdfKind::kDiffuse:
      readDiffuse();
      break;
    case BsdfKind::kRoughPlastic:
      readRoughness();
      [[fallthrough]];
    case BsdfKind::kPlastic:
      readPlastic();
      break;
    case BsdfKind::kRoughConductor:
      readRoughness();
      [[fallthrough]];
    case BsdfKind::kConductor:
      readConductor();
      break;
    case BsdfKind::kRoughDielectric:
      readRoughness();
      [[fallthrough]];
    case BsdfKind::kDielectric:
    case BsdfKind::kThinDielectric:
      readDielectric();
      break;
    case BsdfKind::kMetallicRoughness:
      readMetallicRoughness();
      break;
    case BsdfKind::kCount:
      break;
  }
  if (kind != BsdfKind::kDiffuse && kind != BsdfKind::kMetallicRoughness)
    material_.specular = textures_.readColor(properties_, "specular_reflectance", kWhite);
  if (traitsOf(kind).delta) ignoreRoughness();
  properties_.finish();
}

// Exporters write these for smooth surfaces too, where Mitsuba does not read them.
void BsdfReader::ignoreRoughness() {
  properties_.ignore("string", {"distribution"});
  properties_.ignore("float", {"alpha"});
}

// Mitsuba 0.6 takes either name.
void BsdfReader::readDiffuse() {
  const SurfaceColor other = textures_.readColor(properties_, "diffuse_reflectance", kHalf);
  material_.reflectance = textures_.readColor(properties_, "reflectance", other);
}

void BsdfReader::readPlastic() {
  readIor(kPolypropylene);
  material_.reflectance = textures_.readColor(properties_, "diffuse_reflectance", kHalf);
  material_.model.nonlinear = properties_.flag("nonlinear", false);
}

// A part of an index. Colours outside of Rec. 709 have parts below 0, which become 0.
std::optional<Rgb> BsdfReader::readIndex(const std::string& name) {
  constexpr float kMax = std::numeric_limits<float>::max();
  std::optional<Rgb> index = properties_.quantity(name, kMax, -1);
  if (index) index = Rgb{std::max(index->x, 0.f), std::max(index->y, 0.f), std::max(index->z, 0.f)};
  return index;
}

// eta and k, or a metal by name.
void BsdfReader::readConductor() {
  const auto eta = readIndex("eta"), k = readIndex("k");
  const std::string name = properties_.text("material");
  const float outside = static_cast<float>(index("ext_eta", "vacuum"));
  if (eta.has_value() != k.has_value() || (eta && !name.empty()))
    throw file_.error(bsdf_, "a metal needs eta and k, or <string name=\"material\">, or neither");
  ComplexIndex metal{name, eta.value_or(Rgb{}), k.value_or(Rgb{})};
  if (!eta) {
    const ComplexIndex* found = findConductor(name.empty() ? file_.isMitsuba0() ? "Cu" : "none" : name);
    if (!found) throw file_.error(bsdf_, "the metal '" + name + "' is not known; known: " + conductorNames());
    metal = *found;
  }
  material_.model.eta = metal.eta / outside;
  material_.model.k = metal.k / outside;
}

void BsdfReader::readDielectric() {
  readIor(kGlass);
  constexpr float kLeastBend =
      1e-3f;  // nearer to 1, numbers are too coarse to tell microfacets from straight on
  if (material_.model.kind == BsdfKind::kRoughDielectric && std::abs(material_.model.ior - 1) < kLeastBend)
    throw file_.error(bsdf_, "int_ior and ext_ior of rough glass must differ by 0.001 at least");
  material_.transmittance = textures_.readColor(properties_, "specular_transmittance", kWhite);
}

// Our own, with names as those of Mitsuba's principled.
void BsdfReader::readMetallicRoughness() {
  readIor(kGlass);
  material_.reflectance = textures_.readColor(properties_, "base_color", kHalf);
  const double metallic = properties_.number("metallic", 0), roughness = properties_.number("roughness", 0.5);
  if (!(metallic >= 0 && metallic <= 1 && roughness >= 0 && roughness <= 1))
    throw file_.error(bsdf_, "metallic and roughness must be within [0, 1]");
  material_.metallic_roughness =
      constantColor({0, static_cast<float>(roughness), static_cast<float>(metallic)});
}

void BsdfReader::readRoughness() {
  const double both = properties_.number("alpha", 0.1);
  const double alpha = properties_.number("alpha_u", both), across = properties_.number("alpha_v", both);
  if (!(alpha >= 0 && alpha <= 1)) throw file_.error(bsdf_, "alpha must be within [0, 1]");
  if (alpha != across)
    throw file_.error(bsdf_, "alpha_u and alpha_v must be equal: brushed surfaces are not supported");
  material_.model.alpha = static_cast<float>(alpha);
  const std::string distribution = properties_.text("distribution");
  if (!distribution.empty() && distribution != "beckmann" && distribution != "ggx")
    throw file_.error(bsdf_,
                      "the distribution '" + distribution + "' is not supported; supported: beckmann, ggx");
  material_.model.microfacets = distribution == "ggx" ? MicrofacetKind::kGgx : MicrofacetKind::kBeckmann;
  properties_.ignore("boolean", {"sample_visible"});
}

void BsdfReader::readIor(const std::string& interior_default) {
  material_.model.ior = static_cast<float>(index("int_ior", interior_default) / index("ext_ior", kAir));
}

// A number, or a material by name.
double BsdfReader::index(const std::string& name, const std::string& fallback) {
  const std::string given = properties_.text(name), material = given.empty() ? fallback : given;
  const std::optional<double> found = findDielectric(material);
  if (!found)
    throw file_.error(bsdf_,
                      name + ": the material '" + material + "' is not known; known: " + dielectricNames());
  const double value = properties_.number(name, *found);
  if (!(value >= 1e-3 && value <= 1e3)) throw file_.error(bsdf_, name + " must be within [0.001, 1000]");
  return value;
}

}  // namespace

std::vector<std::string> bsdfTypes() {
  std::vector<std::string> names;
  for (const BsdfTraits& row : kBsdfTraits) names.push_back(row.name);
  return names;
}

void readBsdf(const XmlFile& file, pugi::xml_node bsdf, TextureReader& textures, Material& material) {
  const std::string name = supportedType(file, bsdf, bsdfTypes());
  for (const BsdfTraits& row : kBsdfTraits) {
    if (row.name == name) BsdfReader(file, bsdf, textures, material).read(row.kind);
  }
}

}  // namespace saccade
