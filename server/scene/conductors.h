// Metals by their names in Mitsuba, for <string name="material">.
#pragma once

#include <string>

#include "base/vec.h"

namespace saccade {

// Index of refraction eta + ik over that of vacuum, for linear RGB. Not bounded: red light of Rec. 709 is
// redder than any wavelength.
struct ComplexIndex {
  std::string name;
  Rgb eta, k;
};

// The metal of this name, or nullptr. "none" reflects all.
const ComplexIndex* findConductor(const std::string& name);

// "none, Ag, ...": all names there are.
std::string conductorNames();

}  // namespace saccade
