// Options whose meaning depends on the machine that reads them.
#pragma once

#include <string>
#include <vector>

#include "farm/worker/sequence_renderer.h"
#include "saccade/v1/dataset.pb.h"

namespace saccade::farm {

// Replaces a budget, a rate of false events and a change of events by the method and the model that the
// tables of this machine give for them, so that all workers render the same.
void pinOptions(const SequenceRenderer& renderer, const std::vector<std::string>& outputs,
                v1::DataSetSequence& sequence);

}  // namespace saccade::farm
