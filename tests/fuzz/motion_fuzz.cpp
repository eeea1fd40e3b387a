// motion.toml beside a scene.
#include "fuzz/fuzz_target.h"
#include "scene/files/scene_error.h"
#include "scene/motion/own_motions.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

bool read(std::string_view bytes) {
  static const Scratch files;
  static const std::string poses = files.write("path.csv", "0 1 0 0 0 0 0 1\n1 3 0 0 0 0 0 1\n");
  files.write(kMotionFile, std::string(bytes));
  return accepts<SceneError>([&] {
    const auto motions = readOwnMotions(files.path("scene.xml"), {"ball", "toy train"}, {});
    for (const OwnMotion& motion : motions)
      if (motion.path) SACCADE_CHECK(length(motion.path->at(TimeNs{500'000'000}).position) < 4);
  });
}

}  // namespace

const FuzzTarget& fuzzTarget() {
  static const FuzzTarget target{
      {"[ball]\nmotion = \"spin:45\" # degrees\n",
       "[\"toy train\"]\nposes = 'path.csv'\nperiod = 2.5\n[ball]\nmotion = 'swing:-1e-3'\n"},
      {"[ball]", "motion", "poses",    "period",   "=",           "\n",   "\"",  "'",
       "spin:",  "orbit:", "path.csv", "../",      "/",           "nan",  "inf", "-1",
       "1e400",  "1_0",    "{}",       "[[ball]]", "ball.motion", "\xff", "#"},
      read,
      nullptr,
      2000};
  return target;
}

}  // namespace saccade
