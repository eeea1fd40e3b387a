// Chooses the simplified models of a scene that are measured.
#pragma once

#include <functional>
#include <vector>

#include "tables/simplification_table.h"

namespace saccade::eval {

// The whole model without one part, for each of `parts`, and with fewer bounces, down to 0.
std::vector<SceneModel> simplerByOne(const SceneModel& whole, const SceneFeatures& parts);

using MeasureModel = std::function<MeasuredModel(const SceneModel&)>;

// Returns the whole model, the `simpler` ones, and combinations. A combination adds the simplifications one
// by one, the one that changes least first, until more than all events change. It skips those that save no
// time. `measure` is called for models that are not in `simpler`.
std::vector<MeasuredModel> withCombinations(const MeasuredModel& whole,
                                            const std::vector<MeasuredModel>& simpler,
                                            const MeasureModel& measure);

}  // namespace saccade::eval
