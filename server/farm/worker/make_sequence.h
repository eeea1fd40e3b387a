// Makes one sequence of a data set.
#pragma once

#include <string>

#include "farm/dataset/data_set.h"
#include "farm/worker/sequence_renderer.h"

namespace saccade::farm {

enum class Made : unsigned char {
  kDone,
  kRetry,  // failed; another run may make it
  kNever,  // failed; it can never be as it is
};

// Renders a sequence and publishes its folder, or puts its failure on record. The present folder must be
// set.recipeFolder(). `worker`: a name that no other worker has.
Made makeSequence(const DataSet& set, const v1::DataSetSequence& sequence, const std::string& worker,
                  SequenceRenderer& renderer);

// Publishes, or throws what is wrong.
void tryToMake(const DataSet& set, const v1::DataSetSequence& sequence, const std::string& worker,
               SequenceRenderer& renderer);

}  // namespace saccade::farm
