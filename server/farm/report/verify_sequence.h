// The part of verify() for the folder of a sequence.
#pragma once

#include <optional>
#include <string>

#include "farm/report/findings.h"

namespace saccade::farm {

// `planned`: of the table. `listed`: its line of index.jsonl, with the end, where there is one.
void verifySequence(const DataSet& set, const v1::DataSetSequence& planned,
                    const std::optional<std::string>& listed, Findings& findings);

}  // namespace saccade::farm
