#include "scene/mitsuba/mitsuba_gloss.h"

#include <algorithm>
#include <cmath>

namespace saccade {
namespace {

constexpr SurfaceColor kFifth = constantColor({0.2f, 0.2f, 0.2f});

SurfaceColor readColor(BsdfSource& from, const std::string& name, const SurfaceColor& fallback) {
  constexpr float kMost = 1e3f;
  if (const pugi::xml_node texture = from.properties.object("texture", name))
    return from.textures.readTexture(texture);
  const std::optional<Rgb> color = from.properties.share(name, kMost);
  return color ? constantColor(*color) : fallback;
}

float most(Rgb c) {
  return std::max({c.x, c.y, c.z});
}

// Where both colours are more than 1 together, both are scaled, as by Mitsuba's ensureEnergyConservation().
void readColors(BsdfSource& from, Material& material) {
  SurfaceColor& base = material.reflectance = readColor(from, "diffuse_reflectance", kHalf);
  SurfaceColor& gloss = material.specular = readColor(from, "specular_reflectance", kFifth);
  const bool textured = isTextured(base) || isTextured(gloss);
  if (const float sum = most(base.color0 + gloss.color0); !textured && sum > 1)
    base.color0 = base.color0 * (0.99f / sum), gloss.color0 = gloss.color0 * (0.99f / sum);
  if (most(base.color0) > 1 || most(gloss.color0) > 1)
    throw from.error("a reflectance above 1 is not supported beside a texture");
}

}  // namespace

// See PhongLobe for what an exponent is as a roughness.
void readPhong(BsdfSource& from, Material& material) {
  const double exponent = from.properties.number("exponent", 30);
  if (!(exponent >= 0 && exponent <= 1e6)) throw from.error("exponent must be within [0, 1e6]");
  material.model.alpha = static_cast<float>(std::sqrt(2 / (exponent + 2)));
  readColors(from, material);
}

void readWard(BsdfSource& from, Material& material) {
  material.model.alpha = readAlpha(from);
  const std::string variant = from.properties.text("variant");
  if (!variant.empty() && variant != "balanced")
    throw from.error("the variant '" + variant + "' is not supported; supported: balanced");
  readColors(from, material);
}

// Oren and Nayar's, which reflects C1 / pi straight back [Oren and Nayar 1994 (30)]. As in Mitsuba the slopes
// of its facets have the variance alpha^2 / 2.
void readRoughDiffuse(BsdfSource& from) {
  const double alpha = from.properties.number("alpha", 0.2), variance = alpha * alpha / 2;
  if (!(alpha >= 0 && alpha <= 1)) throw from.error("alpha must be within [0, 1]");
  from.properties.flag("use_fast_approx", false);
  const double c1 = 1 - 0.5 * variance / (variance + 0.33);
  if (alpha > 0)
    from.unread.push_back("a roughdiffuse is shown as diffuse, which is up to " +
                          std::to_string(std::lround(100 / c1 - 100)) +
                          " % brighter where light and view are straight on");
}

}  // namespace saccade
