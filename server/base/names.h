// Lists of names for messages, and look-ups in tables whose rows have a `name`.
#pragma once

#include <string>
#include <vector>

namespace saccade {

// "first, second, ..."; "none" where there is none.
template <class Names>
std::string joinNames(const Names& names) {
  std::string joined;
  for (const auto& name : names) {
    if (!joined.empty()) joined += ", ";
    joined += name;
  }
  return joined.empty() ? "none" : joined;
}

// The names of all rows, likewise.
template <class Table>
std::string joinRowNames(const Table& table) {
  std::vector<std::string> names;
  for (const auto& row : table) names.emplace_back(row.name);
  return joinNames(names);
}

// The row called `name`, or nullptr.
template <class Row>
const Row* findRow(const std::vector<Row>& table, const std::string& name) {
  for (const Row& row : table) {
    if (row.name == name) return &row;
  }
  return nullptr;
}

}  // namespace saccade
