// Metals by their names in Mitsuba, for <string name="material">.
#pragma once

#include <string>

#include "base/vec.h"

namespace saccade {

// The complex index of refraction eta + ik, relative to vacuum, for linear RGB. Values may lie outside of the
// range of the spectrum, because the red of Rec. 709 is redder than any wavelength.
struct ComplexIndex {
  std::string name;
  Rgb eta, k;
};

// The metal of this name, or nullptr. "none" reflects all light.
const ComplexIndex* findConductor(const std::string& name);

// All names: "none, Ag, ...".
std::string conductorNames();

}  // namespace saccade
