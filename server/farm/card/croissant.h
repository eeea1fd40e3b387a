// The card of a data set for programs: Croissant 1.0 of MLCommons, which is JSON-LD.
#pragma once

#include <string>
#include <vector>

#include "farm/card/page.h"

namespace saccade::farm {

// croissant.json. It has the sequences as a set of records, one for each line of the files index.jsonl. Equal
// facts give equal bytes. Throws std::system_error where plan.json or the recipe cannot be read.
std::string croissantOf(const CardFacts& facts);

// The options of `saccade-farm card` that give properties which Croissant 1.0 requires, and which these facts
// lack.
std::vector<std::string> lackingFor(const CardFacts& facts);

}  // namespace saccade::farm
