#include "scene/mitsuba/mitsuba_gloss.h"

#include <cmath>

namespace saccade {
namespace {

constexpr SurfaceColor kFifth = constantColor({0.2f, 0.2f, 0.2f});

void readColors(BsdfSource& from, Material& material) {
  material.reflectance = from.textures.readColor(from.properties, "diffuse_reflectance", kHalf);
  material.specular = from.textures.readColor(from.properties, "specular_reflectance", kFifth);
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
