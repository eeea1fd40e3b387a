#include "scene/dielectrics.h"

#include <algorithm>
#include <cctype>
#include <vector>

#include "base/names.h"

namespace saccade {
namespace {

struct Dielectric {
  std::string name;
  double index;
};

// The materials that Mitsuba's manual lists.
const std::vector<Dielectric>& dielectricTable() {
  static const std::vector<Dielectric> table = {
      {"vacuum", 1},        {"helium", 1.000036},        {"hydrogen", 1.000132},
      {"air", 1.000277},    {"carbon dioxide", 1.00045}, {"water", 1.333},
      {"acetone", 1.36},    {"ethanol", 1.361},          {"carbon tetrachloride", 1.461},
      {"glycerol", 1.4729}, {"benzene", 1.501},          {"silicone oil", 1.52045},
      {"bromine", 1.661},   {"water ice", 1.31},         {"fused quartz", 1.458},
      {"pyrex", 1.47},      {"acrylic glass", 1.49},     {"polypropylene", 1.49},
      {"bk7", 1.5046},      {"sodium chloride", 1.544},  {"amber", 1.55},
      {"pet", 1.575},       {"diamond", 2.419},
  };
  return table;
}

std::string inSmallLetters(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return name;
}

}  // namespace

std::optional<double> findDielectric(const std::string& name) {
  const Dielectric* found = findRow(dielectricTable(), inSmallLetters(name));
  return found ? std::optional(found->index) : std::nullopt;
}

std::string dielectricNames() {
  return joinRowNames(dielectricTable());
}

}  // namespace saccade
