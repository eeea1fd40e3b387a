// Reads a CSV file of measurements. Its first line holds the settings of all rows, the second the columns:
//   # cpu="AMD EPYC" size=128x128 bounces=3     key=value or key="any text"
//   scene,method,spp,cpu_ms                     in any order
//   cornell-box,pt,1,12.5
#pragma once

#include <fstream>
#include <initializer_list>
#include <map>
#include <string>
#include <vector>

namespace saccade {

// All faults are std::runtime_error naming file and line.
class TableFile {
 public:
  // Reads the first line. `kind` describes the file for the error "this is no ...".
  TableFile(const std::string& path, const std::string& kind);

  const std::string& settings() const { return settings_; }     // the first line, without its "# "
  void readColumns(std::initializer_list<const char*> needed);  // the file may have others
  bool nextRow();                                               // false at the end

  // Whether the settings or the columns have it, with another value than "nan".
  bool has(const std::string& name) const;
  // A value of the row, or of the settings.
  const std::string& field(const std::string& name) const;
  double number(const std::string& name, double min, double max) const;
  int integer(const std::string& name, int min, int max) const;

  // Throws for the line that was read last.
  [[noreturn]] void fail(const std::string& what) const;

 private:
  bool nextLine() { return ++number_, static_cast<bool>(std::getline(file_, line_)); }
  void readSettings(const std::string& kind);
  std::vector<std::string> splitLine() const;

  const std::string path_;
  std::ifstream file_;
  std::string line_, settings_;
  int number_ = 0;
  std::vector<std::string> columns_;
  std::map<std::string, std::string> fields_;
};

}  // namespace saccade
