// The methods that charts and figures compare.
#pragma once

#include <string>
#include <vector>

namespace saccade::eval {

// Every method of methodTable(), in its order, with its defaults. SVGF has a second entry, with the faults of
// Falcor's shaders.
std::vector<std::string> comparedMethods();

// Each method with a tolerance of luminance, `sigma_l`, with each of these values of it. The tolerance of the
// difference is the same, where the method has one.
std::vector<std::string> luminanceSweep(const std::vector<std::string>& values);

}  // namespace saccade::eval
