// Checks of options. CLI::Range lets NaN pass.
#pragma once

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <exception>
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

// Numbers of 64 bits, such as seeds. By itself CLI11 takes -1 for the largest of them, and cuts what is
// larger.
inline CLI::Validator wholeNumber() {
  return CLI::Validator(
      [](const std::string& text) {
        std::uint64_t value = 0;
        const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
        const bool whole = fault == std::errc() && end == text.data() + text.size();
        return whole ? std::string() : "'" + text + "' is not a whole number from 0 to 18446744073709551615";
      },
      "");
}

// Texts that `parse` reads, which throws std::exception for others.
CLI::Validator readBy(auto parse) {
  return CLI::Validator(
      [parse](const std::string& text) {
        try {
          parse(text);
          return std::string();
        } catch (const std::exception& fault) {
          return std::string(fault.what());
        }
      },
      "");
}

}  // namespace saccade
