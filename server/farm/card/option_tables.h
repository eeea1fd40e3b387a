// The part of a card that tells how a recipe gives values to sequences.
#pragma once

#include <string>

#include "farm/card/statistics.h"

namespace saccade::farm {

// "uniform in [0.1, 0.3]", in Markdown.
std::string describe(const Draw& draw);

// A table of all options, and one for each case with those that differ between cases.
std::string optionTables(const Recipe& recipe);

// A table of what was drawn: least, median, greatest and the histogram of numbers; how often other values
// came.
std::string drawnTables(const Statistics& found);

}  // namespace saccade::farm
