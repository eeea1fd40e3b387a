// Look-ups in a table whose rows have names.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

namespace saccade {

// The row called `name`, or nullptr.
template <class Row>
const Row* findRow(const std::vector<Row>& table, const std::string& name) {
  const auto found =
      std::find_if(table.begin(), table.end(), [&](const Row& row) { return row.name == name; });
  return found == table.end() ? nullptr : &*found;
}

// "first, second, ..."
template <class Row>
std::string joinRowNames(const std::vector<Row>& table) {
  std::string names;
  for (const Row& row : table) names += (names.empty() ? "" : ", ") + row.name;
  return names;
}

}  // namespace saccade
