#include "farm/card/licences.h"

#include <algorithm>
#include <filesystem>
#include <fstream>

namespace saccade::farm {
namespace {

constexpr const char* kLabels[] = {"Licence:", "License:"};

// The text behind the label; nothing in other lines.
std::string afterLabel(const std::string& line) {
  for (const std::string label : kLabels)
    if (line.starts_with(label)) return line.substr(std::min(line.size(), label.size() + 1));
  return "";
}

}  // namespace

std::string licenceOf(const std::string& scenes, const std::string& scene) {
  std::ifstream page(std::filesystem::path(scenes) / scene / "README.md");
  std::string line, text;
  while (text.empty() && std::getline(page, line)) text = afterLabel(line);
  while (!text.empty() && std::getline(page, line) && !line.empty()) text += " " + line;
  return text;
}

}  // namespace saccade::farm
