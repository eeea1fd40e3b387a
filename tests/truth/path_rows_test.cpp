// Rows of the camera's path.
#include "render/test_scenes.h"
#include "truth/truth_run.h"

namespace saccade {
namespace {

using test::kFrameTime;

TEST(TruthPath, VelocityComesWithThePosesAndIsTheirDerivative) {
  const Pose start{{1, 2, 3}, axisAngle({0.3, 0.8, -0.2})}, end{{1.5, 2, 2.5}, axisAngle({0.5, 0.6, -0.1})};
  const Trajectory path({{TimeNs(0), start}, {8 * kFrameTime, end}});
  test::TruthRun run(test::furnace(0.5f, 1), path, 8, 6, 60);
  const auto poses = run.source("pose"), velocities = run.source("velocity");
  TruthSamples p, v;
  for (int t = 1; t <= 4; ++t) {
    const FeedInterval interval = run.step();
    for (TruthSample& sample : poses->sample(interval)) p.push_back(std::move(sample));
    for (TruthSample& sample : velocities->sample(interval)) v.push_back(std::move(sample));
  }
  ASSERT_EQ(v.size(), 5u);
  for (std::size_t i = 1; i < 4; ++i) {
    EXPECT_EQ(v[i].t_ns, p[i].t_ns);
    const auto velocity = test::elementsOf<double>(v[i]);
    const auto before = test::elementsOf<double>(p[i - 1]), after = test::elementsOf<double>(p[i + 1]);
    const double span_s = seconds(2 * kFrameTime);
    // Within (h w)^2 / 6 of the speed, h = 0.01 s, w = 4 / s.
    for (std::size_t axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(velocity[axis], (after[axis] - before[axis]) / span_s, 3e-3);
    const Quaternion q0{before[3], before[4], before[5], before[6]},
        q1{after[3], after[4], after[5], after[6]};
    const Vec3d turned = rotationVector(conjugate(q0) * q1) / span_s;
    EXPECT_NEAR(velocity[3], turned.x, 1e-9);
    EXPECT_NEAR(velocity[4], turned.y, 1e-9);
    EXPECT_NEAR(velocity[5], turned.z, 1e-9);
    EXPECT_GT(length(turned), 1);
  }
}

}  // namespace
}  // namespace saccade
