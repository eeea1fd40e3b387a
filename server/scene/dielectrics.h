// Clear materials by their names in Mitsuba, for <string name="int_ior"> and the like.
#pragma once

#include <optional>
#include <string>

namespace saccade {

// The index of refraction of this material, in small or capital letters, relative to vacuum. It is that of
// yellow light (589 nm) at 0 to 20 degrees Celsius [Hecht, Optics].
std::optional<double> findDielectric(const std::string& name);

// All names: "vacuum, helium, ...".
std::string dielectricNames();

}  // namespace saccade
