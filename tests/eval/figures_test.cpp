// `saccade-eval figure N`, `odds` and `chart --budgets` as a user runs them, on very small pictures.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <sstream>
#include <string>

#include "client/scratch_folder.h"

namespace saccade::client {
namespace {

std::string textOf(const std::string& path) {
  std::ostringstream text;
  text << std::ifstream(path).rdbuf();
  return text.str();
}

long linesOf(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n');
}

// The exit code of the command. Its output goes to `log`.
int run(const std::string& arguments, const ScratchFolder& folder) {
  const std::string command = std::string(SACCADE_EVAL) + " " + arguments + " --reference 64 --cache " +
                              folder.at("cache") + " -o " + folder.at("out") + " > " + folder.at("log") +
                              " 2>&1";
  return WEXITSTATUS(std::system(command.c_str()));
}

int figure(const std::string& arguments, const ScratchFolder& folder) {
  return run("figure " + arguments, folder);
}

TEST(Figure5, WritesALineForEachMethodBudgetAndThreshold) {
  ScratchFolder folder;
  ASSERT_EQ(figure("5 cornell-box --size 16x16 --frames 1:3 --methods pt,event_svgf --spp 2,4 "
                   "--thresholds 0.1,0.3",
                   folder),
            0)
      << textOf(folder.at("log"));
  EXPECT_EQ(linesOf(textOf(folder.at("out/figure5.csv"))), 2 + 2 * 2 * 2);
  const std::string svg = textOf(folder.at("out/figure5.svg"));
  for (const char* name : {"pt", "event_svgf", "theory"})
    EXPECT_NE(svg.find(">" + std::string(name) + "<"), std::string::npos) << name;
  EXPECT_EQ(svg.find("nan"), std::string::npos);
}

TEST(Figure7, WritesCurvesSpectraAndReconstructions) {
  ScratchFolder folder;
  ASSERT_EQ(figure("7 cornell-box --size 16x16 --frames 1:4 --methods svgf --thresholds 0.2", folder), 0)
      << textOf(folder.at("log"));
  const std::string time = textOf(folder.at("out/figure7_cornell-box_time.csv"));
  EXPECT_EQ(time.substr(0, time.find('\n')),
            "seconds,truth,svgf direct,svgf complementary,svgf kalman,svgf screened Poisson");
  EXPECT_EQ(linesOf(time), 1 + 5);  // L_0 to L_4
  EXPECT_EQ(linesOf(textOf(folder.at("out/figure7_cornell-box_spectrum.csv"))), 1 + 2);
  EXPECT_EQ(linesOf(textOf(folder.at("out/figure7.csv"))), 2 + 6);
  EXPECT_NE(textOf(folder.at("out/figure7_cornell-box.svg")).find("power density"), std::string::npos);
}

// Nothing changes: there is no power at any frequency, and there are no events on either side.
TEST(Figure7, LivesWithAStandingCamera) {
  ScratchFolder folder;
  ASSERT_EQ(figure("7 cornell-box --size 16x16 --frames 1:3 --trajectory still --methods event_svgf "
                   "--thresholds 0.01",
                   folder),
            0)
      << textOf(folder.at("log"));
  std::istringstream table(textOf(folder.at("out/figure7.csv")));
  std::string line;
  int rows = 0;
  while (std::getline(table, line)) {
    if (!line.starts_with("cornell-box,")) continue;
    ++rows;
    if (line.find("complementary") != line.npos) continue;
    EXPECT_NE(line.find(",0.01,0,0,0,0,0,"), line.npos) << line;
  }
  EXPECT_EQ(rows, 6);
}

// A row for each method and budget. The paths that fit join the table that servers read.
TEST(Chart, ComparesAtEqualTime) {
  ScratchFolder folder;
  ASSERT_EQ(run("chart cornell-box --size 16x16 --frames 2:3 --repeats 1 --spp 2 --methods pt,svgf "
                "--budgets 1,8",
                folder),
            0)
      << textOf(folder.at("log"));
  const std::string budgets = textOf(folder.at("out/budgets.csv")), log = textOf(folder.at("log"));
  EXPECT_EQ(linesOf(budgets), 2 + 2 * 2);
  for (const char* part : {"cornell-box, 8 times the time of two paths: ", "| scene | 1 times | 8 times |"})
    EXPECT_NE(log.find(part), std::string::npos) << part;
  const std::string results = textOf(folder.at("out/results.csv"));
  EXPECT_NE(results.find("\ncornell-box,irradiance_cache,2,"), std::string::npos) << results;
  EXPECT_GT(linesOf(results), 2 + 3);  // more than those of 2 paths
}

TEST(Odds, WriteARowForEachRangeAndAPanelForEachScene) {
  ScratchFolder folder;
  ASSERT_EQ(run("odds cornell-box cornell-bunny --size 16x16 --frames 2:3 --spp 2,4", folder), 0)
      << textOf(folder.at("log"));
  EXPECT_EQ(linesOf(textOf(folder.at("out/odds.csv"))), 2 + 2 * 2 * 10);
  const std::string svg = textOf(folder.at("out/odds.svg"));
  for (const char* name : {"cornell-box", "cornell-bunny", "event_svgf, 2 spp", "event_svgf, 4 spp", "equal"})
    EXPECT_NE(svg.find(">" + std::string(name) + "<"), std::string::npos) << name;
}

TEST(Figure, NamesTheFiguresThatThereAre) {
  ScratchFolder folder;
  EXPECT_EQ(figure("13", folder), 2);
  EXPECT_NE(
      textOf(folder.at("log")).find("there is no figure '13'; there are: 5, 6, 7, 8, 9, 10, 11, 12, all"),
      std::string::npos)
      << textOf(folder.at("log"));
}

// The page names a scene by the folder of its path alone. It shows the pictures.
TEST(Figure6, NamesItsFilesAfterTheScene) {
  ScratchFolder folder;
  const std::string scene = SACCADE_SCENE_FOLDER "/cornell-box/scene.xml";
  ASSERT_EQ(figure("6 " + scene + " --size 16x16 --frames 2 --methods pt --spp 2", folder), 0)
      << textOf(folder.at("log"));
  const std::string svg = textOf(folder.at("out/figure6_cornell-box.svg"));
  for (const char* word : {"full colour ", "darker (OFF)", "no change", "brighter (ON)", "own error"})
    EXPECT_NE(svg.find(word), std::string::npos) << word;
  EXPECT_NE(textOf(folder.at("out/figure6.csv")).find("\ncornell-box,pt,2,"), std::string::npos);
  EXPECT_NE(textOf(folder.at("out/index.html")).find("src=\"figure6_cornell-box.svg\""), std::string::npos);
}

// A flag counts for the figures that have it: 5 and 7 have no --repeats. A body moves.
TEST(FigureAll, MakesEveryFigureAndOnePage) {
  ScratchFolder folder;
  ASSERT_EQ(figure("all cornell-box --size 12x12 --frames 2:3 --repeats 1 --quick "
                   "--object tall_block=slide:-0.03/frame",
                   folder),
            0)
      << textOf(folder.at("log"));
  const std::string page = textOf(folder.at("out/index.html"));
  for (const char* picture : {"5", "6_cornell-box", "7_cornell-box", "8_cornell-box", "9_cornell-box", "10",
                              "10_cornell-box_forward", "11_cornell-box", "12_cornell-box"})
    EXPECT_NE(page.find("src=\"figure" + std::string(picture) + ".svg\""), std::string::npos) << picture;
  for (const char* table : {"5", "6", "7", "8", "9", "10", "11", "12"}) {
    const std::string csv = textOf(folder.at("out/figure" + std::string(table) + ".csv"));
    EXPECT_NE(csv.find(" size=12x12 "), std::string::npos) << table;
    EXPECT_NE(csv.find(" object=\"tall_block=slide:-0.03/frame\""), std::string::npos) << table;
    EXPECT_NE(csv.find("\ncornell-box"), std::string::npos) << table;
  }
  EXPECT_NE(textOf(folder.at("out/figure6.csv")).find("\ncornell-box,relax,32,"), std::string::npos);
  EXPECT_NE(textOf(folder.at("out/figure6.csv")).find(" repeats=1"), std::string::npos);
}

TEST(Figure7, RefusesAPixelOutsideThePicture) {
  ScratchFolder folder;
  EXPECT_NE(figure("7 cornell-box --size 16x16 --frames 1:2 --pixel 16,3", folder), 0);
  EXPECT_NE(textOf(folder.at("log")).find("16x16"), std::string::npos);
}

}  // namespace
}  // namespace saccade::client
