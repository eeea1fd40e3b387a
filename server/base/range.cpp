#include "base/range.h"

#include <sstream>

namespace saccade {

std::string rangeFault(double value, double min, double max) {
  if (value >= min && value <= max) return {};
  std::ostringstream text;
  text.precision(10);
  text << value << " is outside [" << min << ", " << max << "]";
  return text.str();
}

}  // namespace saccade
