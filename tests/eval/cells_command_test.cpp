// `saccade-eval cells` as a user runs it, on very small pictures.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "scene/scratch.h"

namespace saccade {
namespace {

struct CellsCommand : testing::Test {
  Scratch files;

  // Exit code; its output goes to `log`.
  int cells(const std::string& arguments) {
    const std::string command = std::string(SACCADE_EVAL) + " cells " + arguments +
                                " --size 24x24 --bounces 1 --reference 64 --baselines pt@1,svgf@2"
                                " --candidates irradiance_cache@2 --cache " +
                                files.path("cache") + " -o " + files.path("out") + " > " + files.path("log") +
                                " 2>&1";
    return WEXITSTATUS(std::system(command.c_str()));
  }
  std::string text(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(files.path(name)).rdbuf();
    return text.str();
  }
};

TEST_F(CellsCommand, ComparesCandidatesInEachCell) {
  ASSERT_EQ(cells("cornell-box --motions right,shake --speeds 0.67 --frames 2:3"), 0) << text("log");
  const std::string log = text("log");
  for (const char* part : {"cornell-box right 0.67px 2:3: 0.", "cornell-box shake 0.67px 2:3: ", "\n  pt@1 ",
                           "\n  svgf@2 ", "\n  irradiance_cache@2 ", "\n    over the better baseline ",
                           "\nirradiance_cache@2\n  cpu_ms ", "ratios.csv"})
    expectContains(log, part);
  expectContains(text("out/results.csv"), "\ncornell-box right 0.67px 2:3,pt,1,");
  const std::string ratios = text("out/ratios.csv");
  expectContains(ratios, "\ncornell-box,right,0.67,2:3,");
  expectContains(ratios, ",irradiance_cache@2,phase_error,");

  // Nothing that stands is measured again, and other frames are other rows.
  const std::string results = text("out/results.csv");
  ASSERT_EQ(cells("cornell-box --motions right,shake --speeds 0.67 --frames 2:3"), 0) << text("log");
  EXPECT_EQ(text("out/results.csv"), results);
  expectContains(text("log"), "cornell-box shake 0.67px 2:3: ");
  ASSERT_EQ(cells("cornell-box --motions right --speeds 0.67 --frames 2"), 0) << text("log");
  expectContains(text("out/results.csv"), "\ncornell-box right 0.67px 2:3,pt,1,");
  expectContains(text("out/results.csv"), "\ncornell-box right 0.67px 2,pt,1,");
}

// A lamp in a corner of the view, and nothing else.
TEST_F(CellsCommand, TellsWhichCellsItLeavesOut) {
  const std::string scene = files.write("lamp/scene.xml", R"(<scene version="2.0.0">
    <integrator type="path"/>
    <sensor type="perspective">
      <float name="fov" value="45"/>
      <transform name="to_world"><lookat origin="0,0,0" target="0,0,1" up="0,1,0"/></transform>
    </sensor>
    <shape type="rectangle">
      <transform name="to_world">
        <scale value="0.5"/> <rotate y="1" angle="180"/> <translate x="1" y="1" z="5"/>
      </transform>
      <emitter type="area"><rgb name="radiance" value="1"/></emitter>
    </shape>
  </scene>)");
  ASSERT_EQ(cells(scene + " --motions right --speeds 1 --frames 1"), 0) << text("log");
  expectContains(text("log"), "lamp right 1px 1: left out: only ");
  expectContains(text("log"),
                 "left out: 1 of 1 cells\nwrote " + files.path("out/ratios.csv") + ", which says why");
  EXPECT_FALSE(std::filesystem::exists(files.path("out/results.csv")));
  expectContains(text("out/ratios.csv"), "\nlamp,right,1,1,,,,,,,,,,left out: only ");
}

TEST_F(CellsCommand, NamesTheFlagThatIsWrong) {
  EXPECT_EQ(cells("cornell-box --motions fly"), 2);
  expectContains(text("log"), "right,forward,orbit,shake");
  EXPECT_EQ(cells("cornell-box --frames 0"), 2);
  expectContains(text("log"), "--frames");
  ASSERT_EQ(cells("cornell-box --motions right --speeds 1 --frames 1"), 0) << text("log");
  EXPECT_EQ(cells("cornell-box --motions right --speeds 1 --frames 1 --threshold 0.3"), 1);
  expectContains(text("log"), "results.csv was made with other settings");
}

}  // namespace
}  // namespace saccade
