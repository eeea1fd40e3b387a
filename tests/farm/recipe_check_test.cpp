#include "farm/plan/recipe_check.h"

#include <gtest/gtest.h>

#include "farm/recipe/recipe_fault.h"
#include "farm/recipe/recipe_reader.h"
#include "farm/recipe_file.h"
#include "scene/library/find_scenes.h"

namespace saccade::farm {
namespace {

// Lines 1 to 8.
constexpr const char* kGood =
    "name = 'a'\nsequences = 10\n[record]\noutput = 'a.h5'\nscene = 'cornell-box'\nmotion = 'pan:3'\nsize = "
    "'32x24'\n"
    "duration = 0.1\n";

struct RecipeCheckTest : testing::Test {
  // The message without the name of the file: "LINE: ..."; empty: the recipe is valid.
  std::string faultOf(const std::string& text) {
    const RecipeFile file(text);
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(file.folder);
    std::string message;
    try {
      checkRecipe(readRecipe(file.path()), renderer);
    } catch (const RecipeFault& fault) {
      message = std::string(fault.what()).substr(file.path().size() + 1);
    }
    std::filesystem::current_path(before);
    return message;
  }

  SequenceRenderer renderer{
      {.scenes = findScenes(), .meshes = kDefaultMeshes, .bakes = {}, .accuracy = {}, .simplification = {}},
      1};
};

TEST_F(RecipeCheckTest, TakesWhatRecordTakes) {
  EXPECT_EQ(faultOf(kGood), "");
  EXPECT_EQ(
      faultOf(kGood + std::string("threshold = [0.1, 0.2]\ntruth = ['depth', 'pose']\nwrite-poses = true\n")),
      "");
  EXPECT_EQ(faultOf(kGood + std::string("object = ['tall_block=spin:9', 'light=slide:0.1']\n")), "");
  EXPECT_EQ(faultOf(kGood +
                    std::string("noise = ['leak_hz=0.1']\nmethod = 'svgf'\nspp = 4\nset = 'as_falcor=1'\n")),
            "");
}

struct WrongOption {
  const char* line;   // instead of motion, or after the others where it is line 9
  const char* fault;  // a part of the message
  int at = 9;
};

TEST_F(RecipeCheckTest, NamesTheLineOfTheOptionAndWhatIsValid) {
  const WrongOption wrong[] = {
      {"treshold = 0.2",
       "9: record.treshold: `saccade record` has no option --treshold; did you mean threshold"},
      {"force = true", "9: record.force: a farm sets this option itself"},
      {"control = 'tcp://127.0.0.1:1'", "9: record.control: a farm sets this option itself"},
      {"trajectory = 'orbit'", "9: record.trajectory: is the same option as motion"},
      {"threshold = -7", "9: record.threshold: "},
      {"threshold = { uniform = [-1, 0.3] }", "9: record.threshold: "},
      {"rate = 'fast'", "9: record.rate: "},
      {"spp = 3\nmethod = 'event_svgf'", "9: record.spp: "},
      {"method = { each = ['svgf', 'none'] }", "9: record.method: there is no method 'none'; there are: "},
      {"truth = ['depth', 'deepness']", "9: record.truth: "},
      {"preset = 'davis347'", "9: record.preset: "},
      {"calibration = 'none.yaml'", "9: record.calibration: "},
      {"calibration = '/etc/passwd'",
       "9: record.calibration: '/etc/passwd' is not a path within the folder of the recipe"},
      {"imu = '../imu.yaml'\ntruth = 'imu'", "9: record.imu: '../imu.yaml' is not a path within the folder"},
      {"object = 'tall_block=/etc/passwd'",
       "9: record.object: '/etc/passwd' is not a path within the folder of the recipe"},
      {"object = 'tall_block=../a.csv'", "9: record.object: '../a.csv' is not a path within the folder"},
      {"object = 'teapot=spin:9'", "9: record.object: the scene has no object 'teapot'; it has: back_wall"},
      {"labels = true\n[[case]]\noutput = 'b.h5'", "11: record.output: "},
      {"jitter = 'maybe'", "9: record.jitter: "},
  };
  for (const WrongOption& one : wrong) {
    const std::string found = faultOf(kGood + std::string(one.line) + "\n");
    EXPECT_EQ(found.substr(0, std::string(one.fault).size()), one.fault);
  }
}

TEST_F(RecipeCheckTest, LooksAtScenesAndPaths) {
  const auto with = [](const std::string& from, const std::string& to) {
    std::string text = kGood;
    return text.replace(text.find(from), from.size(), to);
  };
  EXPECT_EQ(faultOf(with("'cornell-box'", "{ each = ['cornell-box', 'nowhere'] }")).substr(0, 17),
            "5: record.scene: ");
  EXPECT_EQ(faultOf(with("'pan:3'", "'circle'")).substr(0, 18), "6: record.motion: ");
  EXPECT_EQ(faultOf(with("'pan:3'", "'pan'")).substr(0, 18), "6: record.motion: ");
  EXPECT_EQ(faultOf(with("'pan:3'", "{ choice = ['pan:3', 'missing.csv'] }")).substr(0, 18),
            "6: record.motion: ");
  EXPECT_EQ(faultOf(with("0.1\n", "0\n")).substr(0, 20), "8: record.duration: ");
  EXPECT_EQ(faultOf(with("scene = 'cornell-box'\n", "")), "1: record: there is no scene");
  EXPECT_EQ(faultOf(with("a.h5", "a.xyz")).substr(0, 18), "4: record.output: ");
}

}  // namespace
}  // namespace saccade::farm
