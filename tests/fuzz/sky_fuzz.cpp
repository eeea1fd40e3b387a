// sky.toml beside a scene.
#include "fuzz/fuzz_target.h"
#include "scene/files/scene_error.h"
#include "scene/scratch.h"
#include "scene/sky/sky_file.h"

namespace saccade {
namespace {

bool read(std::string_view bytes) {
  static const Scratch files;
  static const std::string picture = files.write("sky.ppm", "P3 1 1 255  9 8 7");
  files.write(kSkyFile, std::string(bytes));
  return accepts<SceneError>([&] {
    Scene scene;
    FileLoads loads;
    if (!addSkyFile(files.path("scene.glb"), {}, loads, scene)) return;
    loads.run({.threads = 1});
    const Rgb radiance = scene.environment->radiance;
    SACCADE_CHECK(radiance.x >= 0 && radiance.y >= 0 && radiance.z >= 0);
    SACCADE_CHECK(std::abs(determinant(scene.environment->to_world) - 1) < 1e-6);
  });
}

}  // namespace

const FuzzTarget& fuzzTarget() {
  static const FuzzTarget target{
      {"radiance = [0.5, 1, 2e3] # bright\n", "picture = 'sky.ppm'\nradiance = 2\nturn = -90.5\n"},
      {"radiance", "picture", "turn", "=",     "\n",  "[",  "]",        "'",      "\"",   "sky.ppm", "../",
       "nan",      "inf",     "-1",   "1e400", "1_0", "{}", "[[turn]]", "turn.x", "\xff", "#"},
      read,
      nullptr,
      2000};
  return target;
}

}  // namespace saccade
