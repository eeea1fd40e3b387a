// Which animations of a glTF file play.
#include <algorithm>

#include "scene/gltf_scratch.h"
#include "scene/library/scene_format.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;

std::string animation(const std::string& name, int node, int values) {
  return R"({"name":")" + name + R"(","channels":[{"sampler":0,"target":{"node":)" + std::to_string(node) +
         R"(,"path":"translation"}}],"samplers":[{"input":1,"output":)" + std::to_string(values) + "}]}";
}

// A triangle that Walk moves by 1 in a second, and Run by 5. Wave moves another one by 1.
class GltfAnimations : public testing::Test {
 protected:
  GltfAnimations() {
    test::GltfArrays arrays = test::triangle();
    arrays.floats({0, 1}, "SCALAR");
    arrays.floats({0, 0, 0, 1, 0, 0}, "VEC3"), arrays.floats({0, 0, 0, 5, 0, 0}, "VEC3");
    file_ =
        test::writeGltf(files_, arrays,
                        {test::kTriangleMesh, R"("nodes":[{"mesh":0,"name":"it"},{"mesh":0,"name":"hand"}])",
                         R"("animations":[)" + animation("Walk", 0, 2) + "," + animation("Run", 0, 3) + "," +
                             animation("Wave", 1, 2) + "]"});
  }
  // How far the object goes in a second; 0 where it has no motion.
  double speedOf(const std::string& name, const LoadOptions& options = {}) const {
    const Scene scene = loadSceneFile(file_, options);
    const auto motion = std::ranges::find(scene.motions, name, &OwnMotion::name);
    return motion == scene.motions.end() ? 0
                                         : motion->path->at(1s).position.x - motion->path->at(0s).position.x;
  }
  std::string fault(const std::string& motion_toml) const {
    files_.write("motion.toml", motion_toml);
    try {
      outlineSceneFile(file_, {});
    } catch (const SceneError& fault) {
      return fault.what();
    }
    return {};
  }

  const Scratch files_;
  std::string file_;
};

TEST_F(GltfAnimations, PlayTogetherButForThoseThatMoveTheSame) {
  EXPECT_NEAR(speedOf("it"), 1, 1e-6);
  EXPECT_NEAR(speedOf("hand"), 1, 1e-6);
  const std::vector<std::string> unread = outlineSceneFile(file_, {}).unread;
  EXPECT_EQ(
      std::ranges::count(unread,
                         "the animation 'Run' does not play, as one before it moves the same; --animation or "
                         "motion.toml may choose it"),
      1);
}

TEST_F(GltfAnimations, PlayAloneWhereMotionTomlChoosesOne) {
  files_.write("motion.toml", "animation = \"Run\"\n");
  EXPECT_NEAR(speedOf("it"), 5, 1e-6);
  EXPECT_EQ(speedOf("hand"), 0);
}

TEST_F(GltfAnimations, OfTheOptionsComesBeforeThatOfMotionToml) {
  files_.write("motion.toml", "animation = \"Run\"\n");
  EXPECT_EQ(formatOf(file_).animations(file_, {}), (std::vector<std::string>{"Walk", "Run", "Wave"}));
  EXPECT_NEAR(speedOf("it", {.animation = "Walk"}), 1, 1e-6);
  EXPECT_NEAR(speedOf("hand", {.animation = "Wave"}), 1, 1e-6);
  EXPECT_EQ(speedOf("it", {.animation = "Wave"}), 0);
  try {
    outlineSceneFile(file_, {.animation = "Jump"});
    FAIL();
  } catch (const SceneError& fault) {
    EXPECT_EQ(std::string(fault.what()),
              file_ + ": the file has no animation 'Jump'; it has: Walk, Run, Wave");
  }
}

TEST_F(GltfAnimations, ThatAreNotThereAreRefused) {
  const std::string unknown = fault("# which\nanimation = \"Jump\"\n");
  EXPECT_NE(unknown.find("motion.toml:2: the file has no animation 'Jump'; it has: Walk, Run, Wave"),
            std::string::npos)
      << unknown;
  EXPECT_NE(fault("animation = 3\n").find("motion.toml:1: animation is not a text in quotes"),
            std::string::npos);
}

TEST_F(GltfAnimations, AreOfNoOtherFormat) {
  files_.write("motion.toml", "animation = \"Run\"\n");
  const std::string file = files_.write("model.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  try {
    loadSceneFile(file, {});
    FAIL();
  } catch (const SceneError& fault) {
    EXPECT_NE(std::string(fault.what()).find("there is no animation 'Run': only files of glTF have any"),
              std::string::npos);
  }
}

}  // namespace
}  // namespace saccade
