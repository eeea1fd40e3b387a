// The cost of putting bodies in their places:
//   build/dev/bin/pose_speed [SCENE...]
// Prints CPU microseconds for each body of a frame, the best of some rounds: objects of scenes, then cards.
// The last is a skin of 70,000 triangles, whose vertices all follow two joints.
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

// A square of kEdge x kEdge vertices.
void measureSkin() {
  constexpr std::uint32_t kEdge = 188;
  Scene s = test::furnace(0.6f, 1);
  Mesh& mesh = s.meshes.emplace_back();
  mesh.name = "skin", mesh.deformation = 0;
  Deformation& d = s.deformations.emplace_back();
  for (std::uint32_t i = 0; i < kEdge * kEdge; ++i) {
    const float x = static_cast<float>(i % kEdge) / kEdge - 0.5f,
                y = static_cast<float>(i / kEdge) / kEdge - 0.5f;
    d.positions.push_back({x, y, 0}), d.normals.push_back({0, 0, 1});
    d.influences.push_back({{0, 1, 0, 0}, {0.5f - x, 0.5f + x, 0, 0}});
    if (i % kEdge + 1 == kEdge || i / kEdge + 1 == kEdge) continue;
    mesh.triangles.push_back({i, i + 1, i + kEdge}),
        mesh.triangles.push_back({i + 1, i + kEdge + 1, i + kEdge});
  }
  mesh.positions = d.positions, mesh.normals = d.normals;
  mesh.positions.push_back({});  // the spare one
  KeyTrack turn{KeyInterpolation::kLinear, true, 4, {0, 10}, {0, 0, 0, 1, 0, 1, 0, 0}};
  s.nodes = {{{}, {}}, {0, {}, {{NodeTrack::Property::kRotation, turn}}}};
  d.joints = {{0, {}}, {1, {}}};
  print("skin of 70,000 triangles", std::move(s), {"skin"});
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
    saccade::measureSkin();
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "pose_speed: %s\n", fault.what());
    return 1;
  }
}
