#include "scene/mitsuba/bsdf_values.h"

#include "scene/dielectrics.h"

namespace saccade {

double readIndex(BsdfSource& from, const std::string& name, const std::string& fallback) {
  const std::string given = from.properties.text(name), material = given.empty() ? fallback : given;
  const std::optional<double> found = findDielectric(material);
  if (!found)
    throw from.error(name + ": the material '" + material + "' is not known; known: " + dielectricNames());
  const double value = from.properties.number(name, *found);
  if (!(value >= 1e-3 && value <= 1e3)) throw from.error(name + " must be within [0.001, 1000]");
  return value;
}

float readIor(BsdfSource& from, const std::string& interior_default) {
  return static_cast<float>(readIndex(from, "int_ior", interior_default) / readIndex(from, "ext_ior", "air"));
}

float readAlpha(BsdfSource& from) {
  Properties& p = from.properties;
  const double both = p.number("alpha", 0.1), alpha = p.number("alpha_u", both);
  if (!(alpha >= 0 && alpha <= 1)) throw from.error("alpha must be within [0, 1]");
  if (alpha != p.number("alpha_v", both))
    throw from.error("alpha_u and alpha_v must be equal: brushed surfaces are not supported");
  return static_cast<float>(alpha);
}

// The distribution phong of Mitsuba 0.6 has the exponent 2 / alpha^2 - 2 [Walter et al. 2007, 5.2].
void readRoughness(BsdfSource& from, BsdfModel& model) {
  model.alpha = readAlpha(from);
  const std::string distribution = from.properties.text("distribution");
  if (distribution == "phong")
    from.unread.push_back(
        "the distribution phong of microfacets is shown as beckmann, which is nearly the same");
  else if (!distribution.empty() && distribution != "beckmann" && distribution != "ggx")
    throw from.error("the distribution '" + distribution +
                     "' is not supported; supported: beckmann, ggx, phong");
  model.microfacets = distribution == "ggx" ? MicrofacetKind::kGgx : MicrofacetKind::kBeckmann;
  from.properties.ignore("boolean", {"sample_visible"});
}

}  // namespace saccade
