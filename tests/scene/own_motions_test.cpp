// Motions that a scene's folder gives its objects.
#include "scene/motion/own_motions.h"

#include <algorithm>

#include "scene/library/scene_format.h"
#include "scene/library/scene_library.h"
#include "scene/motion/bodies.h"
#include "scene/scene_texts.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;
using namespace std::chrono_literals;

// A scene of two balls: "ball" at the origin, and "other".
class OwnMotions : public testing::Test {
 protected:
  OwnMotions() {
    const auto ball = [](const std::string& id, const char* x) {
      return "<shape type='sphere' id='" + id + "'><point name='center' x='" + x + "' y='0' z='0'/></shape>";
    };
    files_.write("scenes/two/scene.xml", test::kSensor + ball("ball", "0") + ball("other", "5") + "</scene>");
  }

  void writeMotion(const std::string& text) const { files_.write("scenes/two/motion.toml", text); }
  Scene load() const { return SceneLibrary(files_.path("scenes")).load("two"); }
  Trajectory pathOf(const std::string& name) const {
    Scene scene = load();
    const OwnMotion* own = ownMotion(scene, name);
    if (!own) throw std::runtime_error("the scene does not move " + name);
    setBodies(scene, {&name, 1});
    return makeOwnMotion(*own, scene, scene.bodies[0]);
  }
  std::string faultOf(const std::string& text) const {
    writeMotion(text);
    return errorOf([&] { load(); });
  }

  const Scratch files_;
};

TEST_F(OwnMotions, AreNoneWithoutAFile) {
  EXPECT_TRUE(load().motions.empty());
  writeMotion("# nothing moves\n");
  EXPECT_TRUE(load().motions.empty());
}

TEST_F(OwnMotions, OfAKindBeginWhereTheFileHasTheObject) {
  writeMotion("[other]\nmotion = \"slide:2\"\n");
  const Trajectory path = pathOf("other");
  EXPECT_EQ(path.at(0s).position, (Vec3d{5, 0, 0}));
  EXPECT_NEAR(length(path.at(500ms).position - Vec3d{5, 0, 0}), 1, 1e-9);
  EXPECT_EQ(ownMotion(load(), "ball"), nullptr);
}

TEST_F(OwnMotions, OfPosesStandAfterThem) {
  files_.write("scenes/two/path.csv", "10 1 0 0 0 0 0 1\n11 3 0 0 0 0 0 1\n");
  writeMotion("[ball]\nposes = \"path.csv\"\n");
  const Trajectory path = pathOf("ball");
  EXPECT_NEAR(path.at(500ms).position.x, 2, 1e-9);
  EXPECT_EQ(path.at(3s).position.x, 3);
}

TEST_F(OwnMotions, WithAPeriodRepeatForEver) {
  files_.write("scenes/two/path.csv", "10 1 0 0 0 0 0 1\n11 3 0 0 0 0 0 1\n");
  writeMotion("[ball]\nposes = \"path.csv\"\nperiod = 2\n");
  const Trajectory path = pathOf("ball");
  for (const auto turns : {0s, 2s, 2000s}) {
    EXPECT_NEAR(path.at(turns + 500ms).position.x, 2, 1e-9);
    EXPECT_NEAR(path.at(turns + 1s).position.x, 3, 1e-9);
    EXPECT_NEAR(path.at(turns + 1500ms).position.x, 2, 1e-9);  // on the way back
  }
}

TEST_F(OwnMotions, AreSortedByName) {
  writeMotion("[other]\nmotion = \"spin:1\"\n[ball]\nmotion = \"spin:2\"\n");
  const Scene scene = load();
  ASSERT_EQ(scene.motions.size(), 2u);
  EXPECT_EQ(scene.motions[0].name, "ball");
  EXPECT_EQ(scene.motions[0].text, "spin:2");
}

TEST_F(OwnMotions, FaultsNameFileAndLineAndWhatIsValid) {
  const std::string file = files_.path("scenes/two/motion.toml");
  const auto expect = [&](const std::string& text, int line, const std::string& what) {
    const std::string fault = faultOf(text);
    EXPECT_EQ(fault.rfind(file + ":" + std::to_string(line) + ": ", 0), 0u) << fault;
    expectContains(fault, what);
  };
  expect("\n[bal]\nmotion = \"spin:1\"\n", 2, "no object 'bal'; it has: ball, other");
  expect("[ball]\nmotion = \"fly:1\"\n", 2, "'fly' is not a motion of an object; there are: spin, orbit");
  expect("[ball]\nmotion = \"spin\"\n", 2, "'spin' is not KIND:SPEED");
  expect("[ball]\nmotion = \"spin:nan\"\n", 2, "spin:nan");
  expect("[ball]\nmotion = \"spin:0\"\n", 2, "spin:0: of either sign");
  expect("[ball]\nmotion = 9\n", 2, "not a text in quotes");
  expect("[ball]\n", 1, "needs either motion or poses");
  expect("[ball]\nmotion = \"spin:1\"\nposes = \"a.csv\"\n", 1, "needs either motion or poses");
  expect("[ball]\nmotion = \"spin:1\"\nperiod = 2\n", 3, "no other period");
  expect("[ball]\nspeed = 1\nmotion = \"spin:1\"\n", 2, "no key 'speed'; there are: motion, poses, period");
  expect("ball = \"spin:1\"\n", 1, "[turntable]");
  expect("[ball]\nposes = \"none.csv\"\n", 2, "none.csv");
  expect("[ball\n", 1, "");
}

TEST_F(OwnMotions, FaultyPosesNameTheirFileToo) {
  files_.write("scenes/two/bad.csv", "0 1 0 0 0 0 0 1\n1 2 3\n");
  files_.write("scenes/two/good.csv", "0 1 0 0 0 0 0 1\n1 3 0 0 0 0 0 1\n");
  expectContains(faultOf("[ball]\nposes = \"bad.csv\"\n"), "bad.csv:2");
  for (const char* period : {"1", "0.5", "-1", "nan", "inf", "\"2\""})
    expectContains(faultOf(std::string("[ball]\nposes = \"good.csv\"\nperiod = ") + period + "\n"),
                   "motion.toml:2: period must be a number of seconds after the last pose");
}

TEST_F(OwnMotions, ReadNothingOutsideOfTheScene) {
  files_.write("outside.csv", "0 1 0 0 0 0 0 1\n");
  files_.write("scenes/one.csv", "0 1 0 0 0 0 0 1\n");
  fs::create_symlink(files_.path("outside.csv"), files_.path("scenes/two/link.csv"));
  for (const std::string path : {"../one.csv", "../../outside.csv", "link.csv", "/etc/hostname"})
    expectContains(faultOf("[ball]\nposes = \"" + path + "\"\n"), "leads out of the folder");
}

TEST_F(OwnMotions, AreListedBeforeTheSceneIsLoaded) {
  writeMotion("[other]\nmotion = \"spin:1\"\n");
  const SceneLibrary library(files_.path("scenes"));
  std::vector<SceneEntry> entries = library.list();
  ASSERT_EQ(entries.at(0).objects.size(), 2u);
  EXPECT_EQ(entries[0].objects[0].name, "other");
  EXPECT_EQ(entries[0].objects[0].motion, "spin:1");
  EXPECT_EQ(entries[0].objects[1].name, "ball");
  EXPECT_EQ(entries[0].objects[1].motion, "");
  writeMotion("[none]\nmotion = \"spin:1\"\n");
  fs::last_write_time(files_.path("scenes/two/motion.toml"), fs::file_time_type::clock::now() + 1h);
  EXPECT_NE(library.list().at(0).unavailable, "");
}

TEST_F(OwnMotions, AChangeOfTheFileIsAChangeOfTheScene) {
  const SceneLibrary library(files_.path("scenes"));
  const auto before = library.lastChange("two");
  writeMotion("[other]\nmotion = \"spin:1\"\n");
  fs::last_write_time(files_.path("scenes/two/motion.toml"), before + 1s);
  EXPECT_GT(library.lastChange("two"), before);
}

TEST_F(OwnMotions, AnOutlineNamesTheMeshesThatItDoesNotRead) {
  files_.write("scenes/two/part.obj", test::kTriangle);
  files_.write("scenes/two/scene.xml",
               test::kSensor + std::string("<shape type='obj'><string name='filename' value='part.obj'/>"
                                           "</shape><shape type='cube'/></scene>"));
  const Scene outline = outlineSceneFile(files_.path("scenes/two/scene.xml"), {});
  EXPECT_EQ(objectNames(outline), (std::set<std::string>{"cube", "part"}));
  EXPECT_EQ(objectNames(load()), objectNames(outline));
}

}  // namespace
}  // namespace saccade
