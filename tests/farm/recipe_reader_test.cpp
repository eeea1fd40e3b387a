#include "farm/recipe/recipe_reader.h"

#include <gtest/gtest.h>

#include "farm/recipe/recipe_fault.h"
#include "farm/recipe_file.h"

namespace saccade::farm {
namespace {

// Lines 1 to 6.
constexpr const char* kGood =
    "name = 'a'\nsequences = 10\nshards = 2\n[record]\noutput = 'a.h5'\nscene = 'box'\n";

std::string with(std::string text, const std::string& from, const std::string& to) {
  return text.replace(text.find(from), from.size(), to);
}

// The message without the name of the file: "LINE: ...".
std::string faultOf(const std::string& text) {
  const RecipeFile file(text);
  try {
    readRecipe(file.path());
  } catch (const RecipeFault& fault) {
    return std::string(fault.what()).substr(file.path().size() + 1);
  }
  return "";
}

TEST(RecipeReader, ReadsAllThatItNames) {
  const RecipeFile file(
      with(kGood, "shards = 2\n", "shards = 2\nseed = 9\nsplits = { z = 0.25, a = 0.75 }\n"));
  const Recipe recipe = readRecipe(file.path());
  EXPECT_EQ(recipe.name, "a");
  EXPECT_EQ(recipe.sequences, 10u);
  EXPECT_EQ(recipe.shards, 2u);
  EXPECT_EQ(recipe.seed, 9u);
  ASSERT_EQ(recipe.splits.size(), 2u);
  EXPECT_EQ(recipe.splits[0].first, "z");  // in the order of the file
  EXPECT_EQ(recipe.outputs, std::vector<std::string>{"a.h5"});
  ASSERT_EQ(recipe.cases.size(), 1u);
  EXPECT_EQ(recipe.cases[0][0].name, "scene");
}

struct Wrong {
  const char *from, *to;  // in kGood
  const char* fault;      // the beginning of the message
};

class WrongRecipe : public testing::TestWithParam<Wrong> {};

TEST_P(WrongRecipe, IsRefusedWithLineKeyAndWhatIsValid) {
  const auto& [from, to, fault] = GetParam();
  EXPECT_EQ(faultOf(with(kGood, from, to)).substr(0, std::string(fault).size()), fault);
}

const Wrong kWrong[] = {
    {"name = 'a'", "name = ", "1: "},
    {"name = 'a'", "name = 'a", "1: "},
    {"name = 'a'\n", "", "1: there is no name"},
    {"name = 'a'", "name = 7", "1: name: 7 is not a text in quotes"},
    {"name = 'a'", "name = '../a'", "1: name: '../a' is not a name of 1 to 64 letters, digits, - and _"},
    {"name = 'a'", "name = 'a;rm'", "1: name: 'a;rm' is not a name"},
    {"name = 'a'", "name = \"a\\nb\"", "1: name: 'a\nb' is not a name"},
    {"name = 'a'", "name = ''", "1: name: '' is not a name"},
    {"sequences = 10\n", "", "1: there is no sequences"},
    {"sequences = 10", "sequences = 0", "2: sequences: 0 is not a whole number from 1 to 100000000"},
    {"sequences = 10", "sequences = -3", "2: sequences: -3 is not a whole number"},
    {"sequences = 10", "sequences = 1.5", "2: sequences: 1.5 is not a whole number"},
    {"sequences = 10", "sequences = '10'", "2: sequences: '10' is not a whole number"},
    {"sequences = 10", "sequences = 1000000000", "2: sequences: 1000000000 is not a whole number"},
    {"shards = 2", "shards = 0", "3: shards: 0 is not a whole number from 1 to 10"},
    {"shards = 2", "shards = 11", "3: shards: 11 is not a whole number from 1 to 10"},
    {"shards = 2", "sahrds = 2",
     "3: sahrds: unknown key; there are: case, draw, name, record, seed, sequences, shards, splits"},
    {"shards = 2", "shards = 2\nshards = 3", "4: "},
    {"shards = 2", "seed = -1", "3: seed: -1 is not a whole number"},
    {"shards = 2", "splits = 3", "3: splits: give a table of shares"},
    {"shards = 2", "splits = {}", "3: splits: give a table of shares"},
    {"shards = 2", "splits = { a = 0.5, b = 0.4 }", "3: splits: the shares add up to 0.9 instead of 1"},
    {"shards = 2", "splits = { a = 1.5, b = -0.5 }", "3: splits.b: a share is below 0"},
    {"shards = 2", "splits = { a = 'half', b = 0.5 }", "3: splits.a: 'half' is not a finite number"},
    {"shards = 2", "splits = { '/etc' = 1 }", "3: splits./etc: '/etc' is not a name"},
    {"shards = 2", "draw = 3", "3: draw: is not a table"},
    {"shards = 2", "draw = { a = [1, 2] }", "3: draw.a: its values are not single texts or numbers"},
    {"shards = 2", "draw = { a = true }", "3: draw.a: its values are not single texts or numbers"},
    {"[record]\noutput = 'a.h5'\nscene = 'box'\n", "", "1: there is no record"},
    {"output = 'a.h5'\n", "", "4: record: there is no output"},
    {"output = 'a.h5'", "output = '/tmp/a.h5'", "5: record.output: '/tmp/a.h5' has a folder"},
    {"output = 'a.h5'", "output = '../a.h5'", "5: record.output: '../a.h5' has a folder"},
    {"output = 'a.h5'", "output = 'a'", "5: record.output: '' is not a name"},
    {"output = 'a.h5'", "output = 'a b.h5'", "5: record.output: 'a b' is not a name"},
    {"output = 'a.h5'", "output = ['a.h5', 'a.h5']", "5: record.output: 'a.h5' is given twice"},
    {"output = 'a.h5'", "output = { each = ['a.h5'] }", "5: record.output: give a name of a file"},
    {"scene = 'box'", "scene = { eahc = ['a'] }",
     "6: record.scene: is a table without a draw; there are: choice, each, "
     "integer, log_uniform, normal, uniform"},
    {"scene = 'box'", "scene = { each = [] }", "6: record.scene: give an array of at least one value"},
    {"scene = 'box'", "scene = { each = 'a' }", "6: record.scene: give an array of at least one value"},
    {"scene = 'box'", "scene = { each = [{}] }",
     "6: record.scene: {} is not a text, a number, true, false or an array"},
    {"scene = 'box'", "scene = [[1]]",
     "6: record.scene: the array holds [ 1 ], which is not a text or a number"},
    {"scene = 'box'", "scene = 1979-05-27", "6: record.scene: 1979-05-27 is not a text, a number"},
    {"scene = 'box'", "rate = { uniform = [1] }", "6: record.rate: give [least, greatest]"},
    {"scene = 'box'", "rate = { uniform = [3, 1] }", "6: record.rate: the first number is the least"},
    {"scene = 'box'", "rate = { uniform = [1, nan] }", "6: record.rate: nan is not a finite number"},
    {"scene = 'box'", "rate = { uniform = [1, 2], weights = [1] }",
     "6: record.rate: has a key that the draw does not take"},
    {"scene = 'box'", "rate = { uniform = [1, 2], each = [1] }", "6: record.rate: gives two draws"},
    {"scene = 'box'", "rate = { log_uniform = [0, 2] }",
     "6: record.rate: the bounds of a log_uniform are above 0"},
    {"scene = 'box'", "rate = { integer = [0.5, 2] }", "6: record.rate: the bounds are not whole numbers"},
    {"scene = 'box'", "rate = { normal = [1, 1] }", "6: record.rate: give bounds = [least, greatest] too"},
    {"scene = 'box'", "rate = { normal = [1, 0], bounds = [0, 2] }",
     "6: record.rate: the deviation is not above 0"},
    {"scene = 'box'", "rate = { normal = [1, 1], bounds = [50, 60] }",
     "6: record.rate: less than a hundredth"},
    {"scene = 'box'", "rate = { choice = [1, 2], weights = [1] }",
     "6: record.rate: there are 1 weights for 2 values"},
    {"scene = 'box'", "rate = { choice = [1, 2], weights = [0, 0] }", "6: record.rate: all weights are 0"},
    {"scene = 'box'", "rate = { choice = [1, 2], weights = [-1, 2] }", "6: record.rate: a weight is below 0"},
    {"scene = 'box'", "scene = '{nothing}'",
     "6: record.scene: '{nothing}' names no value of [draw]; there are: none"},
    {"scene = 'box'", "scene = 'a{b'", "6: record.scene: 'a{b' names no value of [draw]"},
    {"scene = 'box'", "scene = 'box'\n[case]\nrate = 1", "7: case: write cases as [[case]]"},
    {"scene = 'box'", "scene = 'box'\n[[case]]\nrate = {}", "8: case.rate: is a table without a draw"},
};
INSTANTIATE_TEST_SUITE_P(All, WrongRecipe, testing::ValuesIn(kWrong));

TEST(RecipeReader, NamesAFileThatIsNotThere) {
  EXPECT_THROW(readRecipe("/nowhere/recipe.toml"), std::runtime_error);
  EXPECT_THROW(readRecipe("/tmp"), std::runtime_error);
}

}  // namespace
}  // namespace saccade::farm
