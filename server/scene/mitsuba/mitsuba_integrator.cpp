#include "scene/mitsuba/mitsuba_integrator.h"

#include <algorithm>

#include "scene/mitsuba/xml_properties.h"

namespace saccade {

std::optional<int> readBounces(const XmlFile& file, const std::vector<pugi::xml_node>& integrators) {
  constexpr double kDirect = 2, kDeepest = 1e6;
  for (const pugi::xml_node integrator : integrators) {
    Properties properties(file, integrator);
    const double depth = std::min(properties.number("max_depth", 0), kDeepest);
    if (depth >= 1) return static_cast<int>(std::max(depth - kDirect, 0.0));
    if (const auto inner = readBounces(file, properties.objects("integrator"))) return inner;
  }
  return std::nullopt;
}

}  // namespace saccade
