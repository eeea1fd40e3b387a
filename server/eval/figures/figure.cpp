#include "eval/figures/figure.h"

#include <algorithm>
#include <cstdio>
#include <filesystem>

#include "eval/pictures/write_text.h"

namespace saccade::eval {

std::string FigureOptions::path(const std::string& rest) const {
  std::string name = "figure" + std::to_string(number) + rest;
  std::replace(name.begin(), name.end(), '/', '_');
  return (std::filesystem::path(output) / name).string();
}

void writePicture(const FigureOptions& o, const std::string& rest, const std::string& svg) {
  writeText(o.path(rest), svg);
  std::printf("wrote %s\n", o.path(rest).c_str());
}

}  // namespace saccade::eval
