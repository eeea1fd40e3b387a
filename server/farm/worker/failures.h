// Sequences that could not be made, and why.
#pragma once

#include <optional>
#include <string>

#include "farm/dataset/data_set.h"

namespace saccade::farm {

// A sequence is given up after so many workers have died of it.
inline constexpr std::uint32_t kMostCrashes = 3;

// The record of a sequence; nothing where it has not failed.
std::optional<v1::FailedSequence> failureOf(const DataSet& set, const v1::DataSetSequence& sequence);
bool failedForEver(const DataSet& set, const v1::DataSetSequence& sequence);

// Puts a failure on record, and counts the attempt. `retry`: whether another run may succeed. Returns it as
// it is on record.
v1::FailedSequence recordFailure(const DataSet& set, const v1::DataSetSequence& sequence,
                                 const std::string& message, bool retry);
// The worker that was at the sequence has died.
v1::FailedSequence recordCrash(const DataSet& set, const v1::DataSetSequence& sequence,
                               const std::string& message);
void forgetFailure(const DataSet& set, const v1::DataSetSequence& sequence);

}  // namespace saccade::farm
