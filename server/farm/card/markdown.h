// Pieces of Markdown.
#pragma once

#include <string>
#include <vector>

#include "farm/card/numbers.h"

namespace saccade::farm {

// The text as code, also within a table. Control characters become blanks.
std::string codeOf(const std::string& text);
// The text as it is, also within a table: none of its characters marks anything.
std::string plainOf(const std::string& text);

std::string tableOf(const std::vector<std::string>& heads, const std::vector<std::vector<std::string>>& rows);

std::string shortText(double number);                 // 4 digits, or all before the point
std::string countText(std::uint64_t number);          // "1,234,567"
std::string barsOf(const Numbers::Summary& summary);  // a letter for each bin, as high as it is full

}  // namespace saccade::farm
