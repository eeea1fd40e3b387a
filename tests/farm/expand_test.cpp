#include "farm/recipe/expand.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "farm/recipe/recipe_reader.h"
#include "farm/recipe_file.h"

namespace saccade::farm {
namespace {

constexpr const char* kHead =
    "name = 'a'\nsequences = 60\nshards = 7\nsplits = { train = 0.7, val = 0.1, test = 0.2 }\n";

Recipe recipeOf(const std::string& text) {
  return readRecipe(RecipeFile(kHead + text).path());
}

std::vector<std::string> optionsOf(const Recipe& recipe, std::uint64_t number) {
  const v1::DataSetSequence sequence = sequenceOf(recipe, number);
  return {sequence.options().begin(), sequence.options().end()};
}

std::string optionOf(const Recipe& recipe, std::uint64_t number, const std::string& name) {
  for (const std::string& word : optionsOf(recipe, number))
    if (word.starts_with("--" + name + "=")) return word.substr(name.size() + 3);
  return "";
}

TEST(Expand, GivesTheOptionsOfTheRecord) {
  const Recipe recipe = recipeOf(
      "[record]\noutput = 'a.h5'\nscene = 'box'\nrate = 500\nbias = 1e-3\njitter = true\nlabels = false\n"
      "truth = ['depth', 'ids']\nseed = 5\n");
  EXPECT_EQ(optionsOf(recipe, 3), (std::vector<std::string>{"box", "--bias=0.001", "--jitter", "--rate=500",
                                                            "--seed=5", "--truth=depth", "--truth=ids"}));
}

TEST(Expand, ListsGiveAllCombinationsInTurn) {
  const Recipe recipe = recipeOf(
      "[record]\noutput = 'a.h5'\nscene = { each = ['a', 'b', 'c'] }\nrate = { each = [100, 200] }\n");
  std::map<std::string, int> counts;
  for (std::uint64_t i = 0; i < 60; ++i) ++counts[optionsOf(recipe, i)[0] + optionOf(recipe, i, "rate")];
  ASSERT_EQ(counts.size(), 6u);
  for (const auto& [combination, count] : counts) EXPECT_EQ(count, 10) << combination;
}

TEST(Expand, CasesTakeTurnsAndAddToTheRecord) {
  const Recipe recipe = recipeOf(
      "[record]\noutput = 'a.h5'\nscene = 'a'\nrate = 100\n[[case]]\nrate = 200\n[[case]]\nscene = 'b'\nspp "
      "= 4\n");
  EXPECT_EQ(optionOf(recipe, 0, "rate"), "200");
  EXPECT_EQ(optionOf(recipe, 1, "rate"), "100");
  EXPECT_EQ(optionsOf(recipe, 1)[0], "b");
  EXPECT_EQ(optionOf(recipe, 1, "spp"), "4");
  EXPECT_EQ(optionOf(recipe, 2, "spp"), "");
}

TEST(Expand, DrawnValuesStandInTexts) {
  const Recipe recipe = recipeOf(
      "[draw]\nspeed = { uniform = [0.5, 0.9] }\n[record]\noutput = 'a.h5'\nscene = 'a'\nmotion = "
      "'pan:{speed}px'\n");
  std::set<std::string> speeds;
  for (std::uint64_t i = 0; i < 60; ++i) {
    const auto draws = sequenceOf(recipe, i).draws();
    EXPECT_EQ(optionOf(recipe, i, "motion"), "pan:" + draws.at("speed") + "px");
    speeds.insert(draws.at("speed"));
  }
  EXPECT_GT(speeds.size(), 55u);
}

TEST(Expand, EachSequenceHasSeedsOfItsOwn) {
  const Recipe moving = recipeOf("[record]\noutput = 'a.h5'\nscene = 'a'\nmotion = 'random:1px'\n");
  const Recipe named = recipeOf("[record]\noutput = 'a.h5'\nscene = 'a'\nmotion = 'orbit'\n");
  std::set<std::string> seeds;
  for (std::uint64_t i = 0; i < 60; ++i)
    seeds.insert(optionOf(moving, i, "seed")), seeds.insert(optionOf(moving, i, "motion-seed"));
  EXPECT_EQ(seeds.size(), 120u);
  EXPECT_EQ(optionOf(named, 0, "motion-seed"), "");
}

TEST(Expand, ASequenceDoesNotDependOnItsNeighbours) {
  const std::string text =
      "[draw]\ns = { uniform = [0, 1] }\n[record]\noutput = 'a.h5'\nscene = 'a'\nbias = '{s}'\n";
  const Recipe recipe = recipeOf(text), again = recipeOf(text + "spp = 4\n");
  for (const std::uint64_t i : {59u, 7u, 0u})
    EXPECT_EQ(optionOf(recipe, i, "bias"), optionOf(again, i, "bias"));
}

TEST(Expand, SplitsHaveTheirSizes) {
  const Recipe recipe = recipeOf("[record]\noutput = 'a.h5'\nscene = 'a'\n");
  std::map<std::string, std::uint64_t> counts;
  for (std::uint64_t i = 0; i < 60; ++i) ++counts[sequenceOf(recipe, i).split()];
  EXPECT_EQ(counts["train"], 42u);
  EXPECT_EQ(counts["val"], 6u);
  EXPECT_EQ(counts["test"], 12u);
  EXPECT_EQ(splitSizes(recipe), (std::vector<std::uint64_t>{42, 6, 12}));
}

TEST(Expand, ShardsAreRangesOfEqualSize) {
  for (std::uint64_t sequences : {1u, 7u, 60u, 1000u}) {
    const auto shards = static_cast<std::uint32_t>(std::min<std::uint64_t>(sequences, 7));
    for (std::uint64_t i = 0; i < sequences; ++i) {
      const std::uint32_t shard = shardOf(i, sequences, shards);
      EXPECT_GE(i, firstOf(shard, sequences, shards));
      EXPECT_LT(i, firstOf(shard + 1, sequences, shards));
    }
    EXPECT_EQ(firstOf(shards, sequences, shards), sequences);
    for (std::uint32_t shard = 0; shard < shards; ++shard)
      EXPECT_NEAR(
          static_cast<double>(firstOf(shard + 1, sequences, shards) - firstOf(shard, sequences, shards)),
          static_cast<double>(sequences) / shards, 1);
  }
}

TEST(Expand, ProbesAreAllListsWithBothEnds) {
  const Recipe recipe = recipeOf(
      "[record]\noutput = 'a.h5'\nscene = { each = ['a', 'b'] }\npreset = { choice = ['x', 'y', 'z'] }\nbias "
      "= { uniform = "
      "[1, 2] }\n[[case]]\nspp = 2\n[[case]]\nspp = 4\n");
  std::set<std::string> found;
  for (const Probe& probe : edgeProbes(recipe, 100)) {
    std::string words = std::to_string(probe.of_case);
    for (const std::string& word : probe.sequence.options())
      if (!word.starts_with("--seed")) words += " " + word;
    found.insert(words);
  }
  EXPECT_EQ(found.size(), 2u * 2 * 3 * 2);
  EXPECT_TRUE(found.contains("1 b --bias=2 --preset=z --spp=4"));
}

}  // namespace
}  // namespace saccade::farm
