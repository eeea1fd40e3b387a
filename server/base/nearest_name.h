// What a misspelt name was most likely meant to be.
#pragma once

#include <string>
#include <vector>

namespace saccade {

// The name of `valid`, which is not empty, that takes the fewest changes of a letter (edit distance
// [Levenshtein]); of equals the first.
std::string nearestName(const std::string& name, const std::vector<std::string>& valid);

}  // namespace saccade
