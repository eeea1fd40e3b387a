// Which forms of a scene's model are worth measuring.
#pragma once

#include <functional>
#include <vector>

#include "tables/simplification_table.h"

namespace saccade::eval {

// The whole model without one part, for each of `parts`, and with fewer bounces, down to 0.
std::vector<SceneModel> simplerByOne(const SceneModel& whole, const SceneFeatures& parts);

using MeasureModel = std::function<MeasuredModel(const SceneModel&)>;

// The whole model, the `simpler` ones, and combinations of these: the simplification that changes least comes
// first, and each next one on top of it, until more than all events change. One that saves no time is left
// aside. `measure` is asked for what is not in `simpler` yet.
std::vector<MeasuredModel> withCombinations(const MeasuredModel& whole,
                                            const std::vector<MeasuredModel>& simpler,
                                            const MeasureModel& measure);

}  // namespace saccade::eval
