// Makes the folder of a data set, from a recipe that has been checked.
#pragma once

#include <functional>
#include <string>

#include "farm/dataset/data_set.h"
#include "farm/recipe/recipe.h"
#include "farm/worker/sequence_renderer.h"

namespace saccade::farm {

// Copies the recipe and the files that it names. Writes the table of each shard, and plan.json last. The
// present folder must be that of the recipe. Where the folder has this plan already, changes nothing. Throws
// std::runtime_error: the folder has another plan or other files; RecipeFault: a file is outside the recipe's
// folder. `tell` hears of the share that is done.
DataSet makePlan(const Recipe& recipe, const std::string& folder, const SequenceRenderer& renderer,
                 const std::function<void(double)>& tell);

}  // namespace saccade::farm
