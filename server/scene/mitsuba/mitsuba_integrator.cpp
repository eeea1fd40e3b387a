#include "scene/mitsuba/mitsuba_integrator.h"

#include <algorithm>
#include <set>

#include "scene/mitsuba/xml_properties.h"

namespace saccade {

// Each is read once: references may go in circles.
std::optional<int> readBounces(const XmlFile& file, std::vector<pugi::xml_node> integrators) {
  constexpr double kDirect = 2, kDeepest = 1e6;
  std::reverse(integrators.begin(), integrators.end());  // the next one is the last
  std::set<pugi::xml_node> seen;
  while (!integrators.empty()) {
    const pugi::xml_node integrator = integrators.back();
    integrators.pop_back();
    if (!seen.insert(integrator).second) continue;
    Properties properties(file, integrator);
    const double depth = std::min(properties.number("max_depth", 0), kDeepest);
    if (depth >= 1) return static_cast<int>(std::max(depth - kDirect, 0.0));
    const auto within = properties.objects("integrator");
    integrators.insert(integrators.end(), within.rbegin(), within.rend());
  }
  return std::nullopt;
}

}  // namespace saccade
