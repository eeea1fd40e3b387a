// Numbers that people choose.
#pragma once

#include <string>

namespace saccade {

// Why `value` is not in [min, max], for people; empty if it is. NaN is in no range.
std::string rangeFault(double value, double min, double max);

}  // namespace saccade
