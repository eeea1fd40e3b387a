#include "scene/gltf/gltf_material.h"

#include <algorithm>
#include <cmath>

#include "base/single.h"
#include "scene/files/limits.h"

namespace saccade {
namespace {

constexpr const char* kStrength = "KHR_materials_emissive_strength";
constexpr const char* kIor = "KHR_materials_ior";
constexpr const char* kSpecular = "KHR_materials_specular";
constexpr const char* kTransmission = "KHR_materials_transmission";
constexpr const char* kVolume = "KHR_materials_volume";

// A factor within [0, 1].
float share(const JsonNode& of, const char* key, double fallback) {
  const double value = of.number(key, fallback);
  if (!(value >= 0 && value <= 1)) throw of.error(std::string(key) + " must be within [0, 1]");
  return single(value);
}

Rgb color(const JsonNode& of, const char* key, Rgb fallback, double most) {
  const auto v = of.numbers<3>(key, {fallback.x, fallback.y, fallback.z});
  for (const double part : v)
    if (!(part >= 0 && part <= most)) throw of.error(std::string(key) + " is beyond what it may be");
  return {single(v[0]), single(v[1]), single(v[2])};
}

// One material of the file.
class Reader {
 public:
  Reader(const JsonNode& json, GltfPictures& pictures, Material& material, std::vector<std::string>& unread)
      : json_(json), pictures_(pictures), m_(material), unread_(unread) {}

  void readSurface();
  Rgb readEmission();
  UvSets uvSets() const { return {first_.value_or(0), second_}; }

 private:
  std::optional<SurfaceColor> texture(const JsonNode& of, const char* key, const PictureUse& use);
  void readBase(const JsonNode& pbr);
  void readOpacity(const JsonNode& pbr, float alpha);
  void readNormals();
  void readInterface();
  void readTransmission();
  void tell(const std::string& what) { unread_.push_back("the material " + m_.name + ": " + what); }

  const JsonNode json_;
  GltfPictures& pictures_;
  Material& m_;
  std::vector<std::string>& unread_;
  std::optional<std::size_t> first_, second_;  // sets of texture coordinates
};

// A mesh has two sets of texture coordinates: that of the first texture, and the next other one.
std::optional<SurfaceColor> Reader::texture(const JsonNode& of, const char* key, const PictureUse& use) {
  const auto info = of.find(key);
  if (!info) return {};
  const std::size_t set = GltfPictures::coordinates(*info);
  if (!first_) first_ = set;
  if (set != *first_ && !second_) second_ = set;
  if (set != *first_ && set != *second_) {
    tell(std::string(key) + " is not shown: it has the third set of texture coordinates");
    return {};
  }
  SurfaceColor read = pictures_.read(*info, use);
  read.second_uvs = set != *first_;
  return read;
}

void Reader::readSurface() {
  m_.model.kind = BsdfKind::kMetallicRoughness;
  m_.twosided = true;  // glTF hides backs unless they are doubleSided, which light cannot
  readBase(json_.object("pbrMetallicRoughness"));
  readNormals();
  readInterface();
  readTransmission();
}

void Reader::readBase(const JsonNode& pbr) {
  const auto base = pbr.numbers<4>("baseColorFactor", {1, 1, 1, 1});
  for (const double part : base)
    if (!(part >= 0 && part <= 1)) throw pbr.error("baseColorFactor must be within [0, 1]");
  const Rgb factor{single(base[0]), single(base[1]), single(base[2])};
  m_.reflectance =
      texture(pbr, "baseColorTexture", {PictureUse::Kind::kColor, factor}).value_or(constantColor(factor));
  const Rgb surface{0, share(pbr, "roughnessFactor", 1), share(pbr, "metallicFactor", 1)};
  m_.metallic_roughness = texture(pbr, "metallicRoughnessTexture", {PictureUse::Kind::kNumbers, surface})
                              .value_or(constantColor(surface));
  readOpacity(pbr, single(base[3]));
}

void Reader::readOpacity(const JsonNode& pbr, float alpha) {
  const std::string mode = json_.text("alphaMode", "OPAQUE");
  if (mode == "OPAQUE") return;
  if (mode != "MASK" && mode != "BLEND") throw json_.error("alphaMode is not OPAQUE, MASK or BLEND");
  const bool cut = mode == "MASK";
  const float threshold = single(json_.number("alphaCutoff", 0.5));
  const PictureUse use{cut ? PictureUse::Kind::kCutOut : PictureUse::Kind::kCoverage,
                       {alpha, alpha, alpha},
                       cut ? threshold : 0};
  const float opacity = !cut ? alpha : alpha >= threshold ? 1.f : 0.f;
  m_.opacity = texture(pbr, "baseColorTexture", use).value_or(constantColor({opacity, opacity, opacity}));
}

void Reader::readNormals() {
  const auto normals = texture(json_, "normalTexture", {PictureUse::Kind::kNumbers});
  if (!normals) return;
  m_.normals = *normals;
  m_.normals_scale = single(json_.at("normalTexture").number("scale", 1));
}

// KHR_materials_ior and _specular change what is no metal. The factor of the reflectance at a right angle
// becomes an index that has it.
void Reader::readInterface() {
  constexpr double kMost = 0.9;  // reflectance
  const auto ior = json_.extension(kIor), specular = json_.extension(kSpecular);
  m_.model.ior = single(ior ? ior->number("ior", 1.5) : 1.5);
  if (m_.model.ior < 1) throw ior->error("ior must be at least 1");
  if (!specular) return;
  if (specular->find("specularTexture") || specular->find("specularColorTexture"))
    tell("the textures of KHR_materials_specular are not shown");
  const double factor = share(*specular, "specularFactor", 1) *
                        luminance(color(*specular, "specularColorFactor", {1, 1, 1}, 1e3));
  const double root = (m_.model.ior - 1.0) / (m_.model.ior + 1.0);
  const double reflected = std::sqrt(std::min(root * root * factor, kMost));
  m_.model.ior = single((1 + reflected) / (1 - reflected));
}

// A material that lets half of its light through, or more, is glass. Without a volume it is a pane.
void Reader::readTransmission() {
  constexpr float kSmooth = 1e-3f, kLeastBend = 1e-3f;
  const auto transmission = json_.extension(kTransmission);
  const float factor = transmission ? share(*transmission, "transmissionFactor", 0) : 0;
  if (factor == 0) return;
  if (factor < 1 || transmission->find("transmissionTexture"))
    tell("a part of its light would go through; it is glass from 0.5 on, and opaque below");
  if (factor < 0.5f) return;
  const auto volume = json_.extension(kVolume);
  const bool pane = !volume || volume->number("thicknessFactor", 0) == 0;
  if (volume && volume->find("attenuationDistance")) tell("its volume absorbs no light");
  const float roughness = m_.metallic_roughness.color0.y, alpha = roughness * roughness;
  const bool rough = alpha > kSmooth || isTextured(m_.metallic_roughness);
  const bool spreads = rough && !pane && std::abs(m_.model.ior - 1) >= kLeastBend;
  if (rough && !spreads) tell("panes are smooth");
  if (isTextured(m_.metallic_roughness)) tell("glass has one roughness");
  m_.model.kind = pane      ? BsdfKind::kThinDielectric
                  : spreads ? BsdfKind::kRoughDielectric
                            : BsdfKind::kDielectric;
  m_.model.alpha = isTextured(m_.metallic_roughness) ? 0.25f : std::max(alpha, kSmooth);
  m_.model.microfacets = MicrofacetKind::kGgx;
  m_.transmittance = m_.reflectance;
}

Rgb Reader::readEmission() {
  const auto strength = json_.extension(kStrength);
  const double factor = strength ? strength->number("emissiveStrength", 1) : 1;
  const Rgb given = color(json_, "emissiveFactor", {0, 0, 0}, kMaxRadiance);
  if (!(factor >= 0 && factor * std::max({given.x, given.y, given.z}) <= kMaxRadiance))
    throw json_.error("emissiveStrength must be at least 0, and the light at most 1e18");
  const Rgb emission = given * single(factor);
  if (luminance(emission) <= 0) return {};
  m_.emission = texture(json_, "emissiveTexture", {PictureUse::Kind::kEmission}).value_or(kWhite);
  return emission;
}

}  // namespace

GltfMaterial readMaterial(const JsonNode& json, const std::string& name, GltfPictures& pictures,
                          std::vector<std::string>& unread) {
  GltfMaterial read;
  read.material.name = name;
  Reader reader(json, pictures, read.material, unread);
  reader.readSurface();
  read.emission = reader.readEmission();
  read.emits_back = json.flag("doubleSided", false);
  read.uv_sets = reader.uvSets();
  return read;
}

}  // namespace saccade
