// Finds what could fail later, before anything is rendered.
#pragma once

#include "farm/recipe/recipe.h"
#include "farm/worker/sequence_renderer.h"

namespace saccade::farm {

// Checks the options of sequences on the edges of what the recipe can give, and of its first ones; of some of
// them also their scenes and paths. The present folder must be that of the recipe. Throws RecipeFault, which
// names the option's line and what would be valid.
void checkRecipe(const Recipe& recipe, SequenceRenderer& renderer);

}  // namespace saccade::farm
