// Small pictures in rows and columns, each with a caption, as SVG text that holds them.
#pragma once

#include <string>
#include <vector>

#include "eval/pictures/exr.h"

namespace saccade::eval {

struct GridPicture {
  std::string caption;  // below it
  int width = 0, height = 0;
  std::vector<Rgb8> pixels;
};

// `cells[r][c]` stands in row r under `columns[c]`; every picture is drawn 192 wide.
std::string drawPictureGrid(const std::vector<std::string>& columns, const std::vector<std::string>& rows,
                            const std::vector<std::vector<GridPicture>>& cells);

}  // namespace saccade::eval
