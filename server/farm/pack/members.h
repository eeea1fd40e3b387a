// The names of the files of a sequence in a tar for WebDataset. They begin with the number of the sequence
// and a point, and have no folders. WebDataset takes what stands before the first point for the sample.
#pragma once

#include <string>
#include <vector>

#include "farm/dataset/data_set.h"

namespace saccade::farm {

// "000123.events.raw.truth.depth.000012.exr" of "events.raw.truth/depth/000012.exr".
std::string memberName(const DataSet& set, const v1::DataSetSequence& sequence, const std::string& file);

struct Member {
  std::string name;
  const v1::DataSetFile* file = nullptr;  // nullptr: sequence.json
  std::uint64_t bytes = 0;
};

// In the order of their names. `json_bytes`: of sequence.json. Throws std::runtime_error where two files get
// one name, or one has a place outside of the sequence's folder.
std::vector<Member> membersOf(const DataSet& set, const v1::DataSetSequence& sequence,
                              std::size_t json_bytes);

}  // namespace saccade::farm
