// Values of a recipe's TOML.
#pragma once

#include <toml++/toml.h>

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "farm/recipe/draw.h"

namespace saccade::farm {

// Where a node stands, for its faults.
struct TomlPlace {
  std::string file;
  std::string key;  // "record.threshold"
  int line;
  [[noreturn]] void fail(const std::string& message) const;  // RecipeFault
  TomlPlace below(const std::string& name, const toml::node& node) const;
};

int lineOf(const toml::node& node);
// The entries of a table in the order of the file. That of TOML is the alphabet's.
std::vector<std::pair<std::string, const toml::node*>> inOrder(const toml::table& table);

// Each throws RecipeFault where the node is of another type or outside of its range.
std::string textOf(const toml::node& node, const TomlPlace& place);
std::uint64_t wholeOf(const toml::node& node, std::uint64_t min, std::uint64_t max, const TomlPlace& place);
double numberOf(const toml::node& node, const TomlPlace& place);
// A text, a number, true (a flag), false (nothing), or an array of texts and numbers.
Value valueOf(const toml::node& node, const TomlPlace& place);
// A value, or a table such as { uniform = [0.1, 0.3] }.
Draw drawOf(const toml::node& node, const TomlPlace& place);

}  // namespace saccade::farm
