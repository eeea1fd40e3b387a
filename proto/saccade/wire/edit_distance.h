// How far apart two words are, for suggestions to whoever misspells one.
#pragma once

#include <cstddef>
#include <string>

namespace saccade {

// The least number of letters to insert, delete or replace that makes `b` of `a` [Levenshtein].
std::size_t editDistance(const std::string& a, const std::string& b);

}  // namespace saccade
