// From a recipe to its sequences.
#pragma once

#include "farm/recipe/recipe.h"
#include "saccade/v1/dataset.pb.h"

namespace saccade::farm {

// The sequence with this number, without files. It depends on the recipe and the number alone. Its options
// begin with the scene.
v1::DataSetSequence sequenceOf(const Recipe& recipe, std::uint64_t number);

// The sequences of each split.
std::vector<std::uint64_t> splitSizes(const Recipe& recipe);

// The shard of a sequence, and the first sequence of a shard; that of the shard after the last is
// `sequences`.
std::uint32_t shardOf(std::uint64_t number, std::uint64_t sequences, std::uint32_t shards);
std::uint64_t firstOf(std::uint32_t shard, std::uint64_t sequences, std::uint32_t shards);

// A sequence to be checked ahead, and its element of Recipe::cases.
struct Probe {
  std::size_t of_case;
  v1::DataSetSequence sequence;
};

// Sequences whose values are on the edges of what the recipe can give. Of each case they are all combinations
// of what is listed, with the least and with the greatest numbers. There are at most `most` of a case.
std::vector<Probe> edgeProbes(const Recipe& recipe, std::size_t most);

}  // namespace saccade::farm
