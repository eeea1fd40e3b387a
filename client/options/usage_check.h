// Finds misspelt commands and options, empty values, and options that are given twice, before CLI11 parses
// the line.
#pragma once

#include <CLI/CLI.hpp>
#include <optional>
#include <string>
#include <vector>

namespace saccade::client {

// The first fault of a command line, as a message; empty if there is none of these kinds. `words`: the
// arguments without the program's name.
std::string usageFault(const CLI::App& app, const std::vector<std::string>& words);

// The name nearest to `word`, if less than half of its letters differ.
std::optional<std::string> similarName(const std::string& word, const std::vector<std::string>& names);

}  // namespace saccade::client
