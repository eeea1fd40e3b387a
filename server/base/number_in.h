// The check of an option that takes a number. CLI::Range lets NaN pass.
#pragma once

#include <CLI/CLI.hpp>
#include <cmath>
#include <sstream>
#include <string>
#include <type_traits>

#include "base/range.h"

namespace saccade {

// Both ends are valid. With whole ends, numbers with a fraction are not.
template <class T>
class NumberIn : public CLI::Validator {
 public:
  NumberIn(T min, T max) : Validator(describe(min, max)) {
    func_ = [min, max](const std::string& text) { return faultOf(text, min, max); };
  }

 private:
  static std::string describe(T min, T max) {
    std::ostringstream text;
    text << (std::is_integral_v<T> ? "INT" : "FLOAT") << " in [" << min << ", " << max << "]";
    return text.str();
  }
  static std::string faultOf(const std::string& text, T min, T max) {
    double value = std::nan("");
    if (!CLI::detail::lexical_cast(text, value)) return "'" + text + "' is not a number";
    if (std::is_integral_v<T> && value != std::trunc(value)) return text + " is not a whole number";
    return rangeFault(value, static_cast<double>(min), static_cast<double>(max));
  }
};

}  // namespace saccade
