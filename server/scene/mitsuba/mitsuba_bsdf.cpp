#include "scene/mitsuba/mitsuba_bsdf.h"

#include <limits>

#include "scene/conductors.h"

namespace saccade {
namespace {

// Mitsuba's defaults.
constexpr double kAirIor = 1.000277, kGlassIor = 1.5046, kPolypropyleneIor = 1.49;
constexpr Rgb kHalf{0.5f, 0.5f, 0.5f}, kOne{1, 1, 1};

// One BSDF, property by property.
class BsdfReader {
 public:
  BsdfReader(const XmlFile& file, pugi::xml_node bsdf, TextureReader& textures, Material& material)
      : file_(file), bsdf_(bsdf), properties_(file, bsdf), textures_(textures), material_(material) {}

  void read(BsdfKind kind);

 private:
  void readPlastic();
  void readConductor();
  void readDielectric();
  void readRoughness();
  void readIor(double interior_default);
  double positive(const std::string& name, double fallback);

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
      material_.reflectance = textures_.readColor(properties_, "reflectance", kHalf);
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
    case BsdfKind::kDielectric:
    case BsdfKind::kThinDielectric:
      readDielectric();
      break;
    case BsdfKind::kCount:
      break;
  }
  if (kind != BsdfKind::kDiffuse)
    material_.specular = textures_.readColor(properties_, "specular_reflectance", kOne);
  properties_.finish();
}

void BsdfReader::readPlastic() {
  readIor(kPolypropyleneIor);
  material_.reflectance = textures_.readColor(properties_, "diffuse_reflectance", kHalf);
  material_.model.nonlinear = properties_.flag("nonlinear", false);
}

// eta and k, or a metal by name.
void BsdfReader::readConductor() {
  constexpr float kMax = std::numeric_limits<float>::max();
  const auto eta = properties_.color("eta", kMax), k = properties_.color("k", kMax);
  const std::string name = properties_.text("material");
  const float outside = static_cast<float>(positive("ext_eta", 1));
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
  readIor(kGlassIor);
  material_.transmittance = textures_.readColor(properties_, "specular_transmittance", kOne);
}

void BsdfReader::readRoughness() {
  const double alpha = properties_.number("alpha", 0.1);
  if (!(alpha >= 0 && alpha <= 1)) throw file_.error(bsdf_, "alpha must be within [0, 1]");
  material_.model.alpha = static_cast<float>(alpha);
  const std::string distribution = properties_.text("distribution");
  if (!distribution.empty() && distribution != "beckmann" && distribution != "ggx")
    throw file_.error(bsdf_,
                      "the distribution '" + distribution + "' is not supported; supported: beckmann, ggx");
  material_.model.microfacets = distribution == "ggx" ? MicrofacetKind::kGgx : MicrofacetKind::kBeckmann;
  properties_.ignore("boolean", {"sample_visible"});
}

void BsdfReader::readIor(double interior_default) {
  material_.model.ior =
      static_cast<float>(positive("int_ior", interior_default) / positive("ext_ior", kAirIor));
}

double BsdfReader::positive(const std::string& name, double fallback) {
  const double value = properties_.number(name, fallback);
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
