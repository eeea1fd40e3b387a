// Error messages for numbers outside their range.
#pragma once

#include <string>

namespace saccade {

// "5 is outside [0, 1]" where `value` is not in [min, max]; empty where it is. NaN is in no range.
std::string rangeFault(double value, double min, double max);

}  // namespace saccade
