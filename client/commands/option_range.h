// Adds the valid range to the help of an option.
#pragma once

#include <CLI/CLI.hpp>
#include <sstream>
#include <string>

#include "wire/ranges.h"

namespace saccade::client {

template <class T>
void sayRange(CLI::App& command, const std::string& name, const Range<T>& range) {
  CLI::Option* option = command.get_option(name);
  std::ostringstream text;
  text << option->get_description() << "; [" << range.min << ", " << range.max << "]";
  option->description(text.str());
}

}  // namespace saccade::client
