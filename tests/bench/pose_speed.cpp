// The cost of putting bodies in their places:
//   build/dev/bin/pose_speed [SCENE...]
// Prints CPU microseconds for each body of a frame, the best of some rounds: objects of scenes, then cards.
#include <algorithm>
#include <cstdio>

#include "base/thread_time.h"
#include "eval/bench/open_scene.h"
#include "render/test_scenes.h"
#include "render/world/posed_scene.h"
#include "scene/motion/bodies.h"
#include "scene/motion/object_motion.h"

namespace saccade {
namespace {

constexpr int kFrames = 200, kRounds = 7;

double microsecondsPerBody(const std::shared_ptr<const RenderScene>& scene) {
  const Scene& s = scene->description();
  std::vector<Trajectory> paths;
  for (const Body& body : s.bodies) paths.push_back(makeObjectMotion({"spin", 90}, s, body));
  PosedScene posed(scene, paths);
  double least = 1e300;
  for (int round = 0; round < kRounds; ++round) {
    const auto began = threadCpuTime();
    for (FrameIndex t = 0; t < kFrames; ++t) posed.setTime(frameTime(t, 250));
    const std::chrono::duration<double, std::micro> all = threadCpuTime() - began;
    least = std::min(least, all.count() / kFrames / static_cast<double>(s.bodies.size()));
  }
  return least;
}

void print(const std::string& name, Scene scene, const std::vector<std::string>& names) {
  setBodies(scene, names);
  const auto shared = std::make_shared<RenderScene>(std::move(scene));
  std::printf("%-24s %8zu %12.1f\n", name.c_str(), names.size(), microsecondsPerBody(shared));
}

// Each shape that stands beside lamps becomes a body.
void measure(const std::string& name) {
  Scene scene = eval::openScene(name)->description();
  std::vector<std::string> names;
  for (const Mesh& mesh : scene.meshes)
    if (!emits(mesh) && !mesh.name.empty()) names.push_back(mesh.name);
  std::ranges::sort(names);
  names.erase(std::unique(names.begin(), names.end()), names.end());
  print(name, std::move(scene), names);
}

void measureCards(int count) {
  Scene s = test::furnace(0.6f, 1);
  std::vector<std::string> names;
  for (int i = 0; i < count; ++i) {
    const float x = static_cast<float>(i) / static_cast<float>(count) - 0.5f;
    s.meshes.push_back(test::quad({x, 0, 0}, {0.1f, 0, 0}, {0, 0.1f, 0}, 0));
    names.push_back(s.meshes.back().name = "card" + std::to_string(i));
  }
  print("cards", std::move(s), names);
}

}  // namespace
}  // namespace saccade

int main(int argc, char** argv) {
  std::vector<std::string> names(argv + 1, argv + argc);
  if (names.empty()) names = {"cornell-box", "cornell-bunny"};
  std::printf("%-24s %8s %12s\n", "scene", "bodies", "us per body");
  try {
    for (const std::string& name : names) saccade::measure(name);
    for (const int count : {1, 8, 64, 256}) saccade::measureCards(count);
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "pose_speed: %s\n", fault.what());
    return 1;
  }
}
