// Reads a recipe. README.md beside this folder describes the file.
#pragma once

#include <string>

#include "farm/recipe/recipe.h"

namespace saccade::farm {

// Throws RecipeFault where the file is no recipe: it names the line, the key and what would be valid. The
// options of [record] are not checked here. Throws std::runtime_error where the file cannot be read.
Recipe readRecipe(const std::string& file);
// Reads the text of a file, whose name is for messages. Throws RecipeFault likewise.
Recipe parseRecipe(const std::string& text, const std::string& file);

}  // namespace saccade::farm
