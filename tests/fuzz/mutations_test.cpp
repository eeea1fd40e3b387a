#include <gtest/gtest.h>

#include "fuzz/mutants.h"

namespace saccade {
namespace {

TEST(Fuzz, SeedsAreAccepted) {
  for (const std::string& seed : fuzzTarget().seeds) EXPECT_TRUE(fuzzTarget().read(seed)) << seed;
}

// Inputs that libFuzzer found of use, and those that once did harm.
TEST(Fuzz, TheCorpusIsReadOrRefused) {
  const auto corpus = readCorpus();
  EXPECT_FALSE(corpus.empty());
  for (const std::string& bytes : corpus) EXPECT_NO_THROW(fuzzTarget().read(bytes)) << bytes;
}

TEST(Fuzz, MutantsAreReadOrRefused) {
  const FuzzTarget& target = fuzzTarget();
  int refused = 0;
  for (int mutant = 0; mutant < target.mutants; ++mutant) {
    const std::string bytes = mutantOf(target, target.seeds, static_cast<std::uint64_t>(mutant));
    try {
      refused += !target.read(bytes);
    } catch (const std::exception& e) {
      ADD_FAILURE() << "mutant " << mutant << ": " << e.what() << "\n" << bytes;
    }
  }
  EXPECT_GT(refused, target.mutants / 4);
  EXPECT_LT(refused, target.mutants);
}

}  // namespace
}  // namespace saccade
