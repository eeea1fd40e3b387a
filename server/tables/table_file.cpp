#include "tables/table_file.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <stdexcept>

#include "base/range.h"

namespace saccade {

TableFile::TableFile(const std::string& path, const std::string& kind) : path_(path), file_(path) {
  if (!file_) throw std::runtime_error(path_ + ": cannot be read");
  readSettings(kind);
}

void TableFile::readSettings(const std::string& kind) {
  if (!nextLine() || !line_.starts_with("# ")) fail("this is no " + kind);
  settings_ = line_.substr(2);
  std::istringstream words(settings_);
  std::string key;
  while (words >> std::ws && std::getline(words, key, '=')) {
    const bool quoted = words.peek() == '"';
    if (quoted) words.ignore();
    if (!std::getline(words, fields_[key], quoted ? '"' : ' ')) fail("\"" + key + "\" has no value");
  }
}

void TableFile::readColumns(std::initializer_list<const char*> needed) {
  if (!nextLine()) fail("the names of the columns are missing");
  columns_ = splitLine();
  for (const char* name : needed) {
    if (std::count(columns_.begin(), columns_.end(), name) != 1) fail(std::string("no column ") + name);
  }
}

bool TableFile::nextRow() {
  if (!nextLine()) return false;
  const std::vector<std::string> cells = splitLine();
  if (cells.size() != columns_.size()) {
    fail(std::to_string(cells.size()) + " values for " + std::to_string(columns_.size()) + " columns");
  }
  for (std::size_t i = 0; i < cells.size(); ++i) fields_[columns_[i]] = cells[i];
  return true;
}

std::vector<std::string> TableFile::splitLine() const {
  std::vector<std::string> cells;
  std::istringstream row(line_);
  for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
  return cells;
}

bool TableFile::has(const std::string& name) const {
  const auto found = fields_.find(name);
  return found != fields_.end() && found->second != "nan";
}

const std::string& TableFile::field(const std::string& name) const {
  const auto found = fields_.find(name);
  if (found == fields_.end()) fail("there is no " + name + "=");
  return found->second;
}

double TableFile::number(const std::string& name, double min, double max) const {
  const std::string& text = field(name);
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != 0) fail(name + " is \"" + text + "\", not a number");
  const std::string fault = rangeFault(value, min, max);
  if (!fault.empty()) fail(name + ": " + fault);
  return value;
}

int TableFile::integer(const std::string& name, int min, int max) const {
  const double value = number(name, min, max);
  if (value != std::floor(value)) fail(name + " must be a whole number");
  return static_cast<int>(value);
}

void TableFile::fail(const std::string& what) const {
  throw std::runtime_error(path_ + ":" + std::to_string(number_) + ": " + what);
}

}  // namespace saccade
