// Draws small pictures in rows and columns as an SVG text that contains them.
#pragma once

#include <string>
#include <vector>

#include "eval/pictures/exr.h"

namespace saccade::eval {

struct GridPicture {
  std::string caption;  // below the picture
  int width = 0, height = 0;
  std::vector<Rgb8> pixels;
};

// The meaning of the colours of signed pictures.
struct ColorKey {
  std::string blue, white, red;
};

// `cells[r][c]` stands in row r under `columns[c]`, 192 wide. Six columns stand side by side; more continue
// below with the same rows. The names of rows and columns break at commas and colons. The key stands at the
// bottom.
std::string drawPictureGrid(const std::vector<std::string>& columns, const std::vector<std::string>& rows,
                            const std::vector<std::vector<GridPicture>>& cells, const ColorKey& key);

}  // namespace saccade::eval
