// The card of a data set as a page for people.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "farm/card/statistics.h"

namespace saccade::farm {

// The contents of a card.
struct CardFacts {
  const DataSet& set;
  const Recipe& recipe;
  const Statistics& found;
  std::map<std::string, std::string> licences = {};  // by scene; empty: not known
  // Properties for hubs, which a data set does not tell; empty: not given.
  std::string url = {}, licence = {}, creator = {}, published = {};
  std::string pictures = {};  // the caption of card/sequences.png; empty: there is none
};

// README.md, in Markdown. Equal facts give equal bytes.
std::string pageOf(const CardFacts& facts);

}  // namespace saccade::farm
