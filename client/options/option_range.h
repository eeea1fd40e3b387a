// The valid range of an option that takes a number: in its help, and as a check.
#pragma once

#include <CLI/CLI.hpp>
#include <sstream>
#include <string>
#include <type_traits>

#include "client/options/request_text.h"
#include "saccade/wire/ranges.h"

namespace saccade::client {

// Why `text` is no number of the range; empty if it is one. NaN is in no range.
std::string rangeFault(const std::string& text, double min, double max, bool whole);

// `name`: of an option of `command`, whose every value must lie in `range`, or be `also`.
template <class T>
void limitTo(CLI::App& command, const std::string& name, const Range<T>& range,
             const std::string& also = {}) {
  CLI::Option* option = command.get_option(name);
  std::ostringstream text;
  text << option->get_description() << "; [" << range.min << ", " << range.max << "]";
  option->description(text.str());
  option->check([range, also](const std::string& value) {
    if (value == also) return std::string();
    return rangeFault(value, static_cast<double>(range.min), static_cast<double>(range.max),
                      std::is_integral_v<T>);
  });
}

}  // namespace saccade::client
