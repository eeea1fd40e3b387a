// Paths through the free space of real scenes, checked against every triangle.
#include <gtest/gtest.h>

#include <algorithm>
#include <numbers>

#include "render/camera/scene_motion.h"
#include "render/camera/view_grid.h"
#include "render/world/scene_space.h"
#include "render/world/triangle_distance.h"
#include "scene/camera/image_speed.h"
#include "scene/library/scene_library.h"
#include "scene/mitsuba/mitsuba_xml.h"
#include "scene/roam/roam.h"
#include "statistical/outside_files.h"

namespace saccade {
namespace {

using namespace std::chrono_literals;

// A ball about a triangle, so that most triangles need no more than a look.
struct Bound {
  Vec3d corners[3], centre;
  double radius;
};

std::vector<Bound> boundsOf(const Scene& scene) {
  std::vector<Bound> bounds;
  for (const Mesh& mesh : scene.meshes)
    for (const auto& triangle : mesh.triangles) {
      Bound b{};
      for (std::size_t i = 0; i < 3; ++i)
        b.corners[i] = toDouble(mesh.positions[triangle[i]]) + scene.origin,
        b.centre = b.centre + b.corners[i] / 3.0;
      for (const Vec3d corner : b.corners) b.radius = std::max(b.radius, length(corner - b.centre));
      bounds.push_back(b);
    }
  return bounds;
}

double distanceTo(const std::vector<Bound>& bounds, Vec3d p) {
  double least = 1e9;
  for (const Bound& b : bounds)
    if (length(p - b.centre) - b.radius < least)
      least = std::min(least, triangleDistance(p, b.corners[0], b.corners[1], b.corners[2]));
  return least;
}

struct RealScene {
  std::string file;
  double clearance;
};

class RoamInScene {
 public:
  explicit RoamInScene(const RealScene& real)
      : scene_(loadMitsubaXml(real.file, {.search_folders = {kDefaultMeshes}})),
        lens_(pinhole(scene_.description().fov_x_deg, 64, 48)),
        clearance_(real.clearance) {}

  Trajectory path(std::uint64_t seed) const {
    return motionIn(scene_, {.kind = kRoam, .speed = 20, .seed = seed, .clearance = clearance_},
                    scene_.description().T_world_camera, lens_);
  }

  void checkDistances(const std::vector<Trajectory>& paths) const {
    const std::vector<Bound> bounds = boundsOf(scene_.description());
    for (const Trajectory& path : paths)
      for (int i = 0; i < 60; ++i)
        EXPECT_GE(distanceTo(bounds, path.at(path.lastTime() / 60 * i).position), clearance_) << i;
  }

  // Between the places of two frames nothing is hit.
  void checkSteps(const Trajectory& path) const {
    const TimeNs step = path.lastTime() / 2000;
    for (TimeNs t{0}; t < path.lastTime(); t += step) {
      const Vec3d from = inScene(path.at(t)), move = inScene(path.at(t + step)) - from;
      EXPECT_FALSE(scene_.geometry().occluded({toFloat(from), toFloat(move), 1})) << seconds(t);
      EXPECT_GT(SceneSpace(scene_).distance(path.at(t).position, 1), clearance_);
    }
  }

  // The median speed of all images, and the least share of a picture with a surface.
  void checkViews(const Trajectory& path) const {
    std::vector<double> steps;
    const TimeNs step = path.lastTime() / 50'000;
    std::size_t least = 64 * 48;
    for (int i = 0; i < 100; ++i) {
      const Pose a = path.at(path.lastTime() / 100 * i), b = path.at(path.lastTime() / 100 * i + step);
      const std::vector<Vec3d> points = probePoints(scene_, a, lens_);
      least = std::min(least, points.size());
      appendImageSteps(viewOf(a, points), {}, inverse(a) * b, lens_, steps);
    }
    EXPECT_GT(least, 64u * 48u / 10);
    std::ranges::nth_element(steps, steps.begin() + std::ssize(steps) / 2);
    const double degrees = steps[steps.size() / 2] / seconds(step) * 180 / std::numbers::pi;
    EXPECT_NEAR(degrees, 20, 2);
  }

  // Of the open box, whose camera is in front of it, at negative z.
  void checkNotBeside(std::uint64_t seeds) const {
    for (std::uint64_t seed = 0; seed < seeds; ++seed) {
      const Trajectory path = this->path(seed);
      for (int i = 0; i < 300; ++i) {
        const Vec3d p = path.at(path.lastTime() / 300 * i).position;
        EXPECT_TRUE(p.z < 0 || (p.x > 0 && p.x < 5.6 && p.y > 0 && p.y < 5.5 && p.z < 5.6)) << seed;
      }
    }
  }

  void checkAll() const {
    std::vector<Trajectory> paths;
    for (std::uint64_t seed = 0; seed < 4; ++seed) paths.push_back(path(seed));
    checkDistances(paths);
    for (const Trajectory& p : paths) checkSteps(p), checkViews(p);
    EXPECT_EQ(path(1).at(1s), paths[1].at(1s));
    EXPECT_NE(paths[1].at(1s), paths[2].at(1s));
  }

 private:
  Vec3d inScene(const Pose& pose) const { return scene_.inScene(pose).position; }

  RenderScene scene_;
  Lens lens_;
  double clearance_;
};

TEST(RoamScenes, CornellBunny) {
  if (!std::filesystem::exists(std::string(kDefaultMeshes) + "/bunny.obj"))
    GTEST_SKIP() << "glmark2-data is not installed";
  const RoamInScene scene({std::string(SACCADE_SOURCE_DIR) + "/scenes/cornell-bunny/scene.xml", 0.3});
  scene.checkAll();
  scene.checkNotBeside(20);
}

TEST(RoamScenes, Staircase) {
  const std::string file = test::realScene("staircase/scene.xml");
  SACCADE_NEEDS(file);
  RoamInScene({file, 0.2}).checkAll();
}

// Its meshes are to be unpacked first.
TEST(RoamScenes, Kitchen) {
  const std::string file = test::realScene("kitchen/scene-289.xml");
  SACCADE_NEEDS(file);
  SACCADE_NEEDS(test::realScene("kitchen/models"));
  RoamInScene({file, 0.15}).checkAll();
}

}  // namespace
}  // namespace saccade
