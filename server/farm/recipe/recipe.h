// A recipe: what sequences a data set has. recipe_reader.h reads one from a file of TOML.
#pragma once

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "farm/recipe/draw.h"

namespace saccade::farm {

// A named value, or an option of `saccade record` without its dashes.
struct Entry {
  std::string name;
  Draw draw;
  int line;  // of the recipe
};

struct Recipe {
  std::string file;       // as it was given, for messages
  std::string path = {};  // of the file, absolute
  std::string name;       // of the data set
  std::uint64_t seed = 0;
  std::uint64_t sequences = 0;                              // [1, kMostSequences]
  std::uint32_t shards = 1;                                 // [1, sequences]
  std::vector<std::pair<std::string, double>> splits = {};  // names and shares, which add up to 1
  std::vector<Entry> draws = {};                            // [draw]
  // [record], with the options of one [[case]] each; at least one. The sequences take them in turn.
  std::vector<std::vector<Entry>> cases = {};
  int output_line = 1;
  std::vector<std::string> outputs = {};  // names of files of events, at least one
};

inline constexpr std::uint64_t kMostSequences = 100'000'000;
inline constexpr std::uint32_t kMostShards = 100'000;

}  // namespace saccade::farm
