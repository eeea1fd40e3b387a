// Suggestions for misspelt names.
#pragma once

#include <string>
#include <vector>

namespace saccade {

// The name of `valid` with the least edit distance [Levenshtein]; the first of equals. `valid` must not be
// empty.
std::string nearestName(const std::string& name, const std::vector<std::string>& valid);

}  // namespace saccade
