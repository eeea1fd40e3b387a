#include "client/calibration/yaml.h"

#include <algorithm>
#include <array>
#include <charconv>

namespace saccade::client {

std::string yamlNumber(double value) {
  std::array<char, 32> digits;
  std::string text(digits.data(), std::to_chars(digits.data(), digits.data() + digits.size(), value).ptr);
  if (text.find('.') == text.npos) text.insert(std::min(text.find('e'), text.size()), ".0");
  return text;
}

std::string yamlList(const std::vector<double>& values) {
  std::string text;
  for (const double value : values) text += (text.empty() ? "" : ", ") + yamlNumber(value);
  return "[" + text + "]";
}

std::string yamlRows(const std::string& indent, const std::vector<double>& values, std::size_t columns) {
  std::string text;
  for (auto row = values.begin(); row < values.end(); row += static_cast<std::ptrdiff_t>(columns))
    text += indent + "- " + yamlList({row, row + static_cast<std::ptrdiff_t>(columns)}) + "\n";
  return text;
}

std::string yamlRows(const std::string& indent, const Transform& transform) {
  return yamlRows(indent, {transform.begin(), transform.end()}, 4);
}

}  // namespace saccade::client
