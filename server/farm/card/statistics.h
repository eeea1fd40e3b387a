// Counts and sums over the sequences of a data set, for its card.
#pragma once

#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "farm/card/numbers.h"
#include "farm/dataset/data_set.h"
#include "farm/recipe/recipe.h"

namespace saccade::farm {

struct Totals {
  std::uint64_t sequences = 0, events = 0, bytes = 0;
  double duration_s = 0;
};

struct Statistics {
  Totals all = {};
  std::map<std::string, Totals> splits = {};
  std::uint32_t shards = 0;                       // that are complete
  std::uint64_t failed = 0;                       // sequences that can never be made, of those shards
  std::vector<v1::FailedSequence> failures = {};  // the first few of them
  std::string digest = {};                        // BLAKE2b over all index.jsonl, in order of the shards

  std::vector<v1::DataSetSequence> samples = {};  // a few from all over the plan, for pictures

  // Of a sequence.
  Numbers events = {}, duration_s = {}, bytes = {};
  Numbers rate = {};  // events per second and pixel of a sensor

  // How many sequences have each.
  std::map<std::string, std::uint64_t> scenes = {}, truth = {}, files = {};  // files of events, by name
  std::map<std::string, std::uint64_t> sizes = {};                           // "346x260", of sensors
  // Values of [draw], and of options that are listed or drawn, by their names: "speed", "--threshold".
  std::map<std::string, Numbers> numbers = {};
  std::map<std::string, std::map<std::string, std::uint64_t>> texts = {};
};

inline constexpr std::size_t kShownFailures = 20;
inline constexpr std::uint64_t kSamples = 8;

// Reads plan.json, recipe/, failed/, and the index.jsonl of the shards that are complete, line by line. The
// memory is 8 bytes for each number of each sequence. `step` hears how many sequences have been counted.
// Throws std::runtime_error where one of them is damaged.
Statistics statisticsOf(const DataSet& set, const Recipe& recipe,
                        const std::function<void(std::uint64_t)>& step);

// The values of an option of a sequence, with ", " between; "yes" for a flag; empty: it is not given.
std::string optionOf(const v1::DataSetSequence& sequence, const std::string& name);

// As on a command line: "scene", "--threshold".
std::string shownName(const std::string& option);

bool isNumber(const Draw& draw);

}  // namespace saccade::farm
