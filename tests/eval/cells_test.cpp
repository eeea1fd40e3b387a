#include "eval/bench/cells.h"

#include <gtest/gtest.h>

#include <set>

namespace saccade::eval {
namespace {

TEST(CellGrid, IsEachWithEachSceneByScene) {
  CellGrid grid;
  grid.scenes = {"cornell-box", "mine/room/scene.xml"}, grid.motions = {"right", "shake"};
  grid.speeds = {0.1, 2}, grid.frames = {{21, 21}, {17, 21}};
  const std::vector<Cell> cells = grid.cells();
  ASSERT_EQ(cells.size(), 16u);
  std::set<std::string> names;
  for (const Cell& cell : cells) names.insert(cell.name());
  EXPECT_EQ(names.size(), cells.size());
  EXPECT_EQ(cells.front().name(), "cornell-box right 0.1px 21");
  EXPECT_EQ(cells.back().name(), "room shake 2px 17:21");
  for (std::size_t i = 0; i < 8; ++i) EXPECT_EQ(cells[i].scene, "cornell-box");
}

TEST(Cell, SetsItsPathAndNothingElse) {
  const Cell cell{"cornell-box", "orbit", 0.33, {17, 21}};
  const BenchSetup setup = cell.setup({.width = 24, .bounces = 7, .reference_spp = 64, .cache = "kept"});
  EXPECT_EQ(setup.scene, "cornell-box");
  EXPECT_EQ(setup.trajectory, "orbit");
  EXPECT_EQ(setup.px_per_frame, 0.33);
  EXPECT_EQ(setup.first, 17);
  EXPECT_EQ(setup.last, 21);
  EXPECT_EQ(setup.width, 24);
  EXPECT_EQ(setup.bounces, 7);
  EXPECT_EQ(setup.reference_spp, 64);
  EXPECT_EQ(setup.cache, "kept");
}

TEST(WhyLeftOut, IsAnEmptyViewOrAStillOne) {
  const Cell cell{"cornell-box", "right", 2, {21, 21}};
  EXPECT_EQ(whyLeftOut(cell, {.surface = 0.5, .px_per_frame = 1.5}), "");
  EXPECT_EQ(whyLeftOut(cell, {.surface = 0.12, .px_per_frame = 2}), "only 12 % of the pixels show a surface");
  EXPECT_EQ(whyLeftOut(cell, {.surface = 1, .px_per_frame = 0}), "the images stand still");
  EXPECT_EQ(whyLeftOut(cell, {.surface = 1, .px_per_frame = 0.019}), "the images stand still");
}

}  // namespace
}  // namespace saccade::eval
