// Truth of the Cornell box against the passes of another program: Cycles, pixel centres, two poses 0.01 apart
// to the right.
#include <gtest/gtest.h>

#include "scene/mitsuba/mitsuba_xml.h"
#include "statistical/npy.h"
#include "statistical/outside_files.h"
#include "truth/truth_run.h"

namespace saccade {
namespace {

using test::Planes;

constexpr int kSize = 128;
constexpr double kShare = 0.995;  // rays of Cycles start up to 0.005 pixels off: edges may differ

std::string passFile(const std::string& name) {
  return test::referenceRender("cornell-box-128/cornell_128_b3_" + name + ".npy");
}

class Counted {
 public:
  void add(bool equal) { ++all_, equal_ += equal; }
  double share() const { return static_cast<double>(equal_) / all_; }

 private:
  int all_ = 0, equal_ = 0;
};

TEST(TruthAndCycles, AgreeOnDepthDistanceNormalsAndFlow) {
  SACCADE_NEEDS(test::realScene("cornell-box/scene.xml"));
  SACCADE_NEEDS(passFile("p0_depth"));
  Scene scene = loadMitsubaXml(test::realScene("cornell-box/scene.xml"));
  const Pose home = scene.T_world_camera;
  const double fov = scene.fov_x_deg, focal = test::Pinhole{kSize, kSize, fov}.focal();
  test::TruthRun run(std::move(scene),
                     Trajectory({{TimeNs(0), home}, {test::kFrameTime, home * Pose{{0.01, 0, 0}, {}}}}),
                     kSize, kSize, fov);
  const Planes depth = run.first("depth"), distance = run.first("distance"), normals = run.first("normals"),
               flow = run.first("flow_forward");
  const auto z = test::readNpy(passFile("p0_depth"), kSize * kSize);
  const auto n = test::readNpy(passFile("p0_normal"), kSize * kSize * 3);
  const auto p = test::readNpy(passFile("p0_position"), kSize * kSize * 3);
  Counted same_depth, same_distance, same_normal, same_flow;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const std::size_t i = static_cast<std::size_t>(y) * kSize + x;
      const Vec3d normal{n[3 * i], n[3 * i + 1], n[3 * i + 2]};
      const Vec3d offset = Vec3d{p[3 * i], p[3 * i + 1], p[3 * i + 2]} - home.position;
      const Vec3d found{normals.at(0, x, y), normals.at(1, x, y), normals.at(2, x, y)};
      same_depth.add(std::abs(depth.at(0, x, y) - z[i]) < 1e-3 * z[i]);
      same_distance.add(std::abs(distance.at(0, x, y) - length(offset)) < 1e-3 * z[i]);
      same_normal.add(length(found - normal) < 0.01);
      // A step to the right moves a point at depth z by focal * 0.01 / z to the left.
      same_flow.add(std::abs(flow.at(0, x, y) + focal * 0.01 / z[i]) < 1e-3 &&
                    std::abs(flow.at(1, x, y)) < 1e-3);
    }
  }
  std::printf("equal: depth %.4f, distance %.4f, normals %.4f, flow %.4f\n", same_depth.share(),
              same_distance.share(), same_normal.share(), same_flow.share());
  EXPECT_GT(same_depth.share(), kShare);
  EXPECT_GT(same_distance.share(), kShare);
  EXPECT_GT(same_normal.share(), kShare);
  EXPECT_GT(same_flow.share(), kShare);
}

}  // namespace
}  // namespace saccade
