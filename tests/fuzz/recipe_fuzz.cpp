#include <gtest/gtest.h>

#include <string>

#include "farm/recipe/expand.h"
#include "farm/recipe/recipe_fault.h"
#include "farm/recipe/recipe_reader.h"
#include "fuzz/fuzz_target.h"

namespace saccade::farm {
namespace {

// Sequences of a recipe that was read, which must depend on the recipe alone.
void checkRecipe(const std::string& text) {
  const Recipe recipe = parseRecipe(text, "fuzz.toml"), again = parseRecipe(text, "fuzz.toml");
  for (const std::uint64_t number : {std::uint64_t{0}, recipe.sequences / 2, recipe.sequences - 1}) {
    const v1::DataSetSequence sequence = sequenceOf(recipe, number);
    EXPECT_EQ(sequence.SerializeAsString().size(), sequenceOf(again, number).SerializeAsString().size());
    EXPECT_LT(sequence.shard(), recipe.shards);
  }
  EXPECT_LE(edgeProbes(recipe, 64).size(), 64 * recipe.cases.size());
}

}  // namespace
}  // namespace saccade::farm

namespace saccade {

const FuzzTarget& fuzzTarget() {
  static const FuzzTarget target{
      {"name = 'a'\nsequences = 10\nshards = 2\nsplits = { x = 0.5, y = 0.5 }\n[draw]\ns = { log_uniform = "
       "[1, 2] }\n"
       "[record]\noutput = ['a.h5', 'b.raw']\nscene = { each = ['c', 'd'] }\nmotion = 'pan:{s}px'\njitter = "
       "true\n"
       "[[case]]\nbias = { normal = [1, 2], bounds = [0, 3] }\n[[case]]\nspp = { integer = [1, 4] }\n",
       "name = 'a'\nsequences = 100000000\n[record]\noutput = 'a.h5'\npreset = { choice = ['a', 'b'], "
       "weights = [1, 0] }\n"},
      {"{ each = [",
       "{ choice = [",
       "{ uniform = [",
       "{ integer = [",
       "{ normal = [",
       "], bounds = [",
       "], weights = [",
       "] }",
       "[[case]]\n",
       "[record]\n",
       "[draw]\n",
       "'{s}'",
       "{",
       "}",
       "= ",
       "\n",
       "true",
       "1e308",
       "-1e308",
       "1e-320",
       "nan",
       "inf",
       "9223372036854775807",
       "-1",
       "0",
       "0.5",
       "''",
       "\"\\n\"",
       "1979-05-27",
       "[[1]]",
       "output",
       "scene"},
      [](std::string_view bytes) {
        return accepts<farm::RecipeFault>([&] { farm::checkRecipe(std::string(bytes)); });
      }};
  return target;
}

}  // namespace saccade
