// The deterministic mutations of a target that its test reads.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "fuzz/fuzz_target.h"

namespace saccade {

// tests/fuzz/corpus/<name of the target>.
const char* corpusFolder();

// The files of corpusFolder(), in the order of their names.
std::vector<std::string> readCorpus();

// One to four changes of one of `originals`.
std::string mutantOf(const FuzzTarget& target, const std::vector<std::string>& originals,
                     std::uint64_t mutant);

}  // namespace saccade
