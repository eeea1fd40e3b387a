// Options whose meaning depends on the machine that reads them.
#pragma once

#include <string>
#include <vector>

#include "farm/worker/sequence_renderer.h"
#include "saccade/v1/dataset.pb.h"

namespace saccade::farm {

// Replaces budget-ms, max-false-rate and max-event-change by the method and the model that the tables of this
// machine give for them. All workers then render the same.
void pinOptions(const SequenceRenderer& renderer, const std::vector<std::string>& outputs,
                v1::DataSetSequence& sequence);

}  // namespace saccade::farm
