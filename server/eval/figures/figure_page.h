// The page index.html of figures.
#pragma once

#include <string>
#include <vector>

#include "eval/figures/figure.h"

namespace saccade::eval {

struct FigureRun {
  const Figure* figure;
  FigureOptions options;
};

// Shows all pictures of the figures that the folder holds, with the settings and the tables of each. Throws
// std::runtime_error.
void writeFigurePage(const std::vector<FigureRun>& runs, const std::string& folder);

}  // namespace saccade::eval
