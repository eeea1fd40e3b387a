// # cpu="AMD EPYC" size=128x128 bounces=3 threshold=0.2 ...    what all rows share; other keys are only told
// scene,method,spp,cpu_ms,false_events,missed_events,...       the columns, in any order and among others
// cornell-box,svgf:as_falcor=1,4,12.5,0.013,0.021,...
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

#include "base/range.h"
#include "methods/accuracy_table.h"

namespace saccade {
namespace {

constexpr const char* kColumns[] = {"scene", "method", "spp", "cpu_ms", "false_events", "missed_events"};

class AccuracyReader {
 public:
  explicit AccuracyReader(const std::string& path) : path_(path), file_(path) {}
  AccuracyTable read();

 private:
  bool nextLine() { return ++number_, static_cast<bool>(std::getline(file_, line_)); }
  void readSettings();
  std::vector<std::string> readColumns();
  MeasuredSetting readRow(const std::vector<std::string>& columns);
  std::vector<std::string> splitLine() const;
  const std::string& field(const std::string& name) const;
  double number(const std::string& name, double min, double max) const;
  int integer(const std::string& name, int min, int max) const;
  [[noreturn]] void fail(const std::string& what) const {
    throw std::runtime_error(path_ + ":" + std::to_string(number_) + ": " + what);
  }

  const std::string& path_;
  std::ifstream file_;
  std::string line_;
  int number_ = 0;
  std::map<std::string, std::string> fields_;  // of the line, by name
  AccuracyTable table_;
};

AccuracyTable AccuracyReader::read() {
  if (!file_) throw std::runtime_error(path_ + ": cannot be read");
  readSettings();
  const std::vector<std::string> columns = readColumns();
  while (nextLine()) table_.rows.push_back(readRow(columns));
  return std::move(table_);
}

// Words key=value or key="any text".
void AccuracyReader::readSettings() {
  if (!nextLine() || !line_.starts_with("# ")) {
    fail("this is no chart's results; they begin with # cpu=\"...\" size=WxH bounces=N threshold=C");
  }
  table_.settings = line_.substr(2);
  std::istringstream words(table_.settings);
  std::string key;
  while (words >> std::ws && std::getline(words, key, '=')) {
    const bool quoted = words.peek() == '"';
    if (quoted) words.ignore();
    if (!std::getline(words, fields_[key], quoted ? '"' : ' ')) fail("\"" + key + "\" has no value");
  }
  table_.cpu = field("cpu");
  char rest = 0;
  if (std::sscanf(field("size").c_str(), "%dx%d%c", &table_.width, &table_.height, &rest) != 2 ||
      std::min(table_.width, table_.height) < 1) {
    fail("size is \"" + field("size") + "\", not WxH");
  }
  table_.bounces = integer("bounces", 0, 64);
  table_.threshold = number("threshold", 1e-3, 10);
}

std::vector<std::string> AccuracyReader::readColumns() {
  if (!nextLine()) fail("the names of the columns are missing");
  std::vector<std::string> columns = splitLine();
  for (const char* name : kColumns) {
    if (std::count(columns.begin(), columns.end(), name) != 1) fail(std::string("no column ") + name);
  }
  return columns;
}

MeasuredSetting AccuracyReader::readRow(const std::vector<std::string>& columns) {
  const std::vector<std::string> cells = splitLine();
  if (cells.size() != columns.size()) {
    fail(std::to_string(cells.size()) + " values for " + std::to_string(columns.size()) + " columns");
  }
  for (std::size_t i = 0; i < cells.size(); ++i) fields_[columns[i]] = cells[i];
  MeasuredSetting row;
  row.scene = field("scene");
  try {
    row.method = parseMethod(field("method"));
  } catch (const std::runtime_error& fault) {
    fail(fault.what());
  }
  row.spp = integer("spp", 1, 65536);
  if (!row.method.takes(row.spp)) fail(row.method.name + " cannot run at " + field("spp") + " spp");
  row.cpu_ms = number("cpu_ms", 0, 1e9);
  row.false_events = number("false_events", 0, 1e9);
  row.missed_events = number("missed_events", 0, 1e9);
  return row;
}

std::vector<std::string> AccuracyReader::splitLine() const {
  std::vector<std::string> cells;
  std::istringstream row(line_);
  for (std::string cell; std::getline(row, cell, ',');) cells.push_back(cell);
  return cells;
}

const std::string& AccuracyReader::field(const std::string& name) const {
  const auto found = fields_.find(name);
  if (found == fields_.end()) fail("there is no " + name + "=");
  return found->second;
}

double AccuracyReader::number(const std::string& name, double min, double max) const {
  const std::string& text = field(name);
  char* end = nullptr;
  const double value = std::strtod(text.c_str(), &end);
  if (text.empty() || *end != 0) fail(name + " is \"" + text + "\", not a number");
  const std::string fault = rangeFault(value, min, max);
  if (!fault.empty()) fail(name + ": " + fault);
  return value;
}

int AccuracyReader::integer(const std::string& name, int min, int max) const {
  const double value = number(name, min, max);
  if (value != std::floor(value)) fail(name + " must be a whole number");
  return static_cast<int>(value);
}

}  // namespace

AccuracyTable readAccuracyTable(const std::string& path) {
  return AccuracyReader(path).read();
}

}  // namespace saccade
