#include "tables/simplification_table.h"

#include <gtest/gtest.h>

#include <filesystem>

#include "scene/scratch.h"

namespace saccade {
namespace {

const std::string kHead =
    "# cpu=\"A CPU @ 2 GHz\" size=100x50 threshold=0.2\n"
    "scene,bounces,disabled,cpu_ms,false_events,missed_events,changed,noise\n";
const std::string kRows =
    "box,3,,20,0,0,0,0\n"
    "box,1,textures+masks,10,0.25,0.5,0.125,0.0625\n"
    "ball,2,,7,0,0,0,0\n"
    "box,2,,15,0.1,0.1,0.05,0\n";

struct SimplificationTableTest : testing::Test {
  Scratch files;
  SimplificationTable read(const std::string& text) {
    return readSimplificationTable(files.write("simplification.csv", text));
  }
  std::string faultOf(const std::string& text) {
    try {
      read(text);
    } catch (const std::runtime_error& fault) {
      return fault.what();
    }
    return "none";
  }
};

TEST_F(SimplificationTableTest, IsReadAsItWasWritten) {
  const SimplificationTable table = read(kHead + kRows);
  EXPECT_EQ(table.cpu, "A CPU @ 2 GHz");
  EXPECT_EQ(table.settings, "cpu=\"A CPU @ 2 GHz\" size=100x50 threshold=0.2");
  EXPECT_EQ(table.scenes(), (std::vector<std::string>{"ball", "box"}));
  const auto box = table.modelsOf("box");
  ASSERT_EQ(box.size(), 3u);
  EXPECT_EQ(box[1].model, (SceneModel{1, {SceneFeature::kTextures, SceneFeature::kMasks}}));
  EXPECT_EQ(box[1].cpu_ms, 10);
  EXPECT_EQ(box[1].false_events, 0.25);
  EXPECT_EQ(box[1].missed_events, 0.5);
  EXPECT_EQ(box[1].changed, 0.125);
  EXPECT_EQ(box[1].noise, 0.0625);
  EXPECT_TRUE(table.modelsOf("bowl").empty());

  const std::string copy = files.path("folder/copy.csv");
  writeSimplificationTable(copy, table);
  std::ifstream file(copy);
  EXPECT_EQ(std::string(std::istreambuf_iterator<char>(file), {}), kHead + kRows);
}

TEST_F(SimplificationTableTest, FaultsNameFileAndLine) {
  const std::pair<std::string, const char*> faults[] = {
      {"scene\n", ":1: this is no table of `saccade-eval simplification`"},
      {"# size=1x1\n", ":1: there is no cpu="},
      {"# cpu=x\nscene,bounces\n", ":2: no column disabled"},
      {kHead + "box,3,wings,1,0,0,0,0\n",
       ":3: disabled: no scene feature is named \"wings\"; there are: textures"},
      {kHead + "box,65,,1,0,0,0,0\n", ":3: bounces: 65 is outside"},
      {kHead + "box,3,,1,0,0,nan,0\n", ":3: changed: nan is outside"},
      {kHead + "box,3,masks,1,0,0,0,0\n", ":3: the first row of box must be its whole model"},
      {kHead + "box,3,,1,0,0,0.1,0\n", ":3: the first row of box must be its whole model"},
  };
  for (const auto& [text, fault] : faults) {
    const std::string told = faultOf(text);
    EXPECT_EQ(told.find(files.path("simplification.csv") + fault), 0u) << told << "\nnot: " << fault;
  }
}

TEST_F(SimplificationTableTest, TheCheapestKeepsTheTolerance) {
  const auto box = read(kHead + kRows).modelsOf("box");
  const auto bounces = [&](double tolerance) { return cheapest(box, tolerance).model.bounces; };
  EXPECT_EQ(bounces(0.049), 3);
  EXPECT_EQ(bounces(0.05), 2);
  EXPECT_EQ(bounces(0.124), 2);
  EXPECT_EQ(bounces(0.125), 1);
}

TEST_F(SimplificationTableTest, AModelSaysWhatItDoesWithout) {
  EXPECT_EQ((SceneModel{3, {}}).text(), "3 bounces");
  EXPECT_EQ((SceneModel{1, {SceneFeature::kMasks, SceneFeature::kTextures}}).text(),
            "1 bounce, without textures, masks");
}

}  // namespace
}  // namespace saccade
