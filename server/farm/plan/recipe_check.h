// Finds what could fail later, before anything is rendered.
#pragma once

#include "farm/recipe/recipe.h"
#include "farm/worker/sequence_renderer.h"

namespace saccade::farm {

// Checks the options of the first sequences, and of some on the edges of what the recipe can give. Of some it
// also loads the scene and finds the path. The present folder must be that of the recipe. Throws RecipeFault,
// which names the option's line and what would be valid.
void checkRecipe(const Recipe& recipe, SequenceRenderer& renderer);

}  // namespace saccade::farm
