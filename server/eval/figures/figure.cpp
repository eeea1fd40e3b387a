#include "eval/figures/figure.h"

#include <cstdio>
#include <filesystem>

#include "eval/pictures/text.h"

namespace saccade::eval {

std::string FigureOptions::path(const std::string& rest) const {
  return (std::filesystem::path(output) / ("figure" + std::to_string(number) + rest)).string();
}

void writePicture(const FigureOptions& o, const std::string& rest, const std::string& svg) {
  writeText(o.path(rest), svg);
  std::printf("wrote %s\n", o.path(rest).c_str());
}

}  // namespace saccade::eval
