// The sets of records in croissant.json.
#pragma once

#include <string>

#include "farm/card/page.h"

namespace saccade::farm {

inline constexpr const char* kIndexId = "index";  // of the files index.jsonl

// The splits, and the sequences with what was drawn for them.
std::string croissantRecords(const CardFacts& facts);

}  // namespace saccade::farm
