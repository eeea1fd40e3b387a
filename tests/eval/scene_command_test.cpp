// `saccade-eval scene` as a user runs it.
#include <gtest/gtest.h>
#include <sys/wait.h>

#include <cstdlib>
#include <fstream>
#include <sstream>

#include "scene/scene_texts.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

struct SceneCommand : testing::Test {
  Scratch files;
  std::string log;

  int exitCodeOf(const std::string& scene) {
    const std::string command =
        std::string(SACCADE_EVAL) + " scene '" + scene + "' > " + files.path("log") + " 2>&1";
    const int code = WEXITSTATUS(std::system(command.c_str()));
    std::ostringstream text;
    text << std::ifstream(files.path("log")).rdbuf();
    log = text.str();
    return code;
  }
};

TEST_F(SceneCommand, TellsWhatASceneHolds) {
  ASSERT_EQ(exitCodeOf("cornell-box"), 0) << log;
  for (const char* part : {"\nobjects   ", "holds     32 triangles, ", " diffuse, 1 area light, ",
                           "\ncamera    ", " MiB, with the tree", " s of CPU to read"})
    expectContains(log, part);
  files.write("mesh/model.obj", test::kTriangle);
  ASSERT_EQ(exitCodeOf(files.path("mesh")), 0) << log;
  expectContains(log,
                 "holds     1 triangle, 1 mesh, 1 diffuse, 1 environment, 1 directional light, 1 channel");
  expectContains(log, "not read  the file has no camera: a default one sees all of the scene");
}

// Each fault once, with its line, and the rest is counted.
TEST_F(SceneCommand, TellsAllFaultsOfAFileAtOnce) {
  const std::string path = files.write(
      "bad/scene.xml", std::string(test::kSensor) +
                           "\n<bsdf type='velvet' id='a'/>\n<shape type='cube'><ref id='a'/></shape>"
                           "\n<shape type='cube'><ref id='a'/></shape>\n<shape type='cube'/>"
                           "\n<shape type='obj'><string name='filename' value='absent.obj'/></shape>"
                           "\n<emitter type='laser'/>\n<medium/>\n</scene>");
  EXPECT_EQ(exitCodeOf(path), 1);
  expectContains(log, "holds     12 triangles, ");
  for (const char* fault : {"scene.xml:2: the bsdf type 'velvet' is not supported; supported: diffuse, ",
                            "scene.xml:6: ", "scene.xml:7: the emitter type 'laser'",
                            "scene.xml:8: <medium> is not supported in <scene",
                            "does not open: leave out or replace what has a fault (4)"})
    expectContains(log, fault);
  EXPECT_EQ(log.find("velvet"), log.rfind("velvet"));
}

TEST_F(SceneCommand, TellsWhyNothingOpens) {
  EXPECT_EQ(exitCodeOf(files.write("torn/scene.xml", "<scene>\n<shape>\n</scene>")), 1);
  expectContains(log, "fault     " + files.path("torn/scene.xml") + ":3: faulty XML");
  EXPECT_EQ(exitCodeOf("no-such-scene"), 1);
  expectContains(log, "no scene is named 'no-such-scene'; there are: ");
  EXPECT_EQ(exitCodeOf("a.fbx"), 1);
  expectContains(log, "a.fbx is not a scene of Mitsuba");
  expectContains(log, "saccade-eval: a.fbx cannot be opened at all");
}

}  // namespace
}  // namespace saccade
