// Optical flow against closed forms of rotation, translation and occlusion.
#include "feed/room.h"
#include "render/deforming_shapes.h"
#include "scene/motion/bodies.h"
#include "truth/truth_run.h"

namespace saccade {
namespace {

using test::kFrameTime;
using test::Pinhole;
using test::Planes;
using test::TruthRun;

constexpr int kW = 48, kH = 36;
constexpr Pinhole kLens{kW, kH, 80};

// By the same step from frame to frame.
Trajectory steps(const Pose& start, const Pose& step) {
  return Trajectory({{TimeNs(0), start}, {kFrameTime, start * step}, {2 * kFrameTime, start * step * step}});
}

TEST(TruthFlow, OfARotationIsThatOfDirectionsAtAnyDepth) {
  const Pose turn{{}, axisAngle({0.03, -0.06, 0.02})};
  TruthRun run(test::room()->description(), steps({{0, 0, -0.9}, {}}, turn), kW, kH, kLens.fov_x_deg);
  const FeedInterval interval = run.step();
  int inside = 0, valid = 0;
  for (const auto& [name, rotation] :
       {std::pair("flow_forward", conjugate(turn.rotation)), std::pair("flow_backward", turn.rotation)}) {
    const Planes flow = run.planesOf(run.source(name)->sample(interval).front());
    for (int y = 0; y < kH; ++y) {
      for (int x = 0; x < kW; ++x) {
        const Vec3d d = rotate(rotation, kLens.direction(x, y));
        const double to_x = kLens.columnOf(d), to_y = kLens.rowOf(d);
        EXPECT_NEAR(flow.at(0, x, y), to_x - x, 1e-3) << name;
        EXPECT_NEAR(flow.at(1, x, y), to_y - y, 1e-3) << name;
        const double margin = std::min({to_x, to_y, kW - 1 - to_x, kH - 1 - to_y}) + 0.5;
        if (margin < -0.01) {
          EXPECT_EQ(flow.at(2, x, y), 0) << name;
        }
        if (margin > 0.01) ++inside, valid += flow.at(2, x, y) == 1;
      }
    }
  }
  // A rotation uncovers nothing. At edges the nearest pixel may show another surface.
  EXPECT_GT(inside, kW * kH);
  EXPECT_LT(inside, 2 * kW * kH * 0.95);
  EXPECT_GT(valid, 0.97 * inside);
}

// A wall 4 ahead, of which a quad 2 ahead hides all columns left of the principal point. The camera goes to
// the right: the wall moves by f * step / 4 to the left, and the quad by twice that.
TEST(TruthFlow, OfATranslationIsInverseToDepthAndInvalidAtOcclusions) {
  Scene s;
  s.materials = {test::grey(0.5f)};
  s.meshes = {test::quad({-9, -9, 4}, {0, 18, 0}, {18, 0, 0}, 0),
              test::quad({-9, -9, 2}, {0, 18, 0}, {9, 0, 0}, 0)};
  const double shift = 6, step = 4 * shift / kLens.focal();
  TruthRun run(s, steps({}, {{step, 0, 0}, {}}), kW, kH, kLens.fov_x_deg);
  const FeedInterval interval = run.step();
  const Planes forward = run.planesOf(run.source("flow_forward")->sample(interval).front());
  const Planes backward = run.planesOf(run.source("flow_backward")->sample(interval).front());
  const double edge0 = (kW - 1) / 2.0, edge1 = edge0 - 2 * shift;  // of the quad, in either frame
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) {
      const auto check = [&](const Planes& flow, double edge, double other_edge, double sign) {
        const bool near = x < edge;
        const double to = x + sign * (near ? 2 * shift : shift);
        EXPECT_NEAR(flow.at(0, x, y), to - x, 1e-3) << x;
        EXPECT_NEAR(flow.at(1, x, y), 0, 1e-3);
        if (std::abs(to - other_edge) < 0.6 || std::abs(to - kW + 0.5) < 0.1) return;
        const bool inside = to > -0.5 && to < kW - 0.5;
        const bool covered = !near && to < other_edge;
        EXPECT_EQ(flow.at(2, x, y), inside && !covered ? 1 : 0) << x << " to " << to;
      };
      check(forward, edge0, edge1, -1);
      check(backward, edge1, edge0, 1);
    }
  }
}

// A quad 2 ahead goes to the right by f * step / 2 pixels before a wall, and the camera stands.
TEST(TruthFlow, OfABodyIsThatOfItsMotionAndOfTheWallNothing) {
  Scene s;
  s.materials = {test::grey(0.5f)};
  s.meshes = {test::quad({-9, -9, 4}, {0, 18, 0}, {18, 0, 0}, 0),
              test::quad({-9, -9, 2}, {0, 18, 0}, {9, 0, 0}, 0)};
  s.meshes[1].name = "quad";
  const std::string names[]{"quad"};
  setBodies(s, names);
  const double shift = 6, step = 2 * shift / kLens.focal();
  const Vec3d start = toDouble(s.bodies[0].centre());
  const Trajectory path({{TimeNs(0), {start, {}}}, {kFrameTime, {start + Vec3d{step, 0, 0}, {}}}});
  TruthRun run(s, steps({}, {}), kW, kH, kLens.fov_x_deg, {path});
  const FeedInterval interval = run.step();
  const Planes forward = run.planesOf(run.source("flow_forward")->sample(interval).front());
  const Planes backward = run.planesOf(run.source("flow_backward")->sample(interval).front());
  const double edge0 = (kW - 1) / 2.0, edge1 = edge0 + shift;  // of the quad, in either frame
  for (int x = 0; x < kW; ++x) {
    EXPECT_NEAR(forward.at(0, x, 5), x < edge0 ? shift : 0, 1e-3) << x;
    EXPECT_NEAR(backward.at(0, x, 5), x < edge1 ? -shift : 0, 1e-3) << x;
    EXPECT_NEAR(forward.at(1, x, 5), 0, 1e-3);
    const bool covered = x > edge0 && x < edge1;  // the wall is seen before, and then is not
    if (x + shift < kW - 1 || x > edge0) {
      EXPECT_EQ(forward.at(2, x, 5), covered ? 0 : 1) << x;
    }
  }
}

// A wall z = 4 + w s x bends from w = 0 to 1. A ray (d, e, 1) meets it at x = z d. There the wall is at
// 4 + v s x at the other time.
TEST(TruthFlow, OfAWallThatBendsFollowsItsPoints) {
  Scene s;
  s.materials = {test::grey(0.5f)};
  s.meshes = {test::quad({-9, -9, 4}, {0, 18, 0}, {18, 0, 0}, 0)};
  s.meshes[0].name = "wall";
  constexpr float kSlope = 0.2f;
  test::setBending(s, "wall", kSlope, 0.01f);
  const Trajectory path({{TimeNs(0), {toDouble(s.bodies[0].centre()), {}}}});
  TruthRun run(s, steps({}, {}), kW, kH, kLens.fov_x_deg, {path});
  const FeedInterval interval = run.step();
  const Planes forward = run.planesOf(run.source("flow_forward")->sample(interval).front());
  const Planes backward = run.planesOf(run.source("flow_backward")->sample(interval).front());
  const auto flow = [&](int x, int y, double here, double there) {
    const Vec3d d = kLens.direction(x, y);
    const double z = 4 / (1 - here * kSlope * d.x);
    const Vec3d at{d.x * z, d.y * z, 4 + there * kSlope * d.x * z};
    return std::pair(kLens.columnOf(at) - x, kLens.rowOf(at) - y);
  };
  for (int y = 0; y < kH; ++y)
    for (int x = 0; x < kW; ++x) {
      EXPECT_NEAR(forward.at(0, x, y), flow(x, y, 0, 1).first, 1e-3);
      EXPECT_NEAR(forward.at(1, x, y), flow(x, y, 0, 1).second, 1e-3);
      EXPECT_NEAR(backward.at(0, x, y), flow(x, y, 1, 0).first, 1e-3);
      EXPECT_NEAR(backward.at(1, x, y), flow(x, y, 1, 0).second, 1e-3);
    }
}

float sampled(const Planes& planes, int plane, float x, float y) {
  const int x0 = static_cast<int>(x), y0 = static_cast<int>(y);
  const float u = x - static_cast<float>(x0), v = y - static_cast<float>(y0);
  const auto row = [&](int yi) {
    return (1 - u) * planes.at(plane, x0, yi) + u * planes.at(plane, x0 + 1, yi);
  };
  return (1 - v) * row(y0) + v * row(y0 + 1);
}

TEST(TruthFlow, ThereAndBackIsNothingAndTheRenderersMotionIsTheSame) {
  const Pose step{{0.05, 0.02, 0.03}, axisAngle({0.01, 0.02, 0.03})};
  TruthRun run(test::room()->description(), steps({{0, 0, -0.9}, {}}, step), kW, kH, kLens.fov_x_deg);
  const FeedInterval interval = run.step();
  const Planes forward = run.planesOf(run.source("flow_forward")->sample(interval).front());
  const Planes backward = run.planesOf(run.source("flow_backward")->sample(interval).front());
  const GBuffer& g = interval.rendered->frames.cur.g;
  int valid = 0, consistent = 0;
  for (int y = 0; y < kH; ++y) {
    for (int x = 0; x < kW; ++x) {
      EXPECT_NEAR(backward.at(0, x, y), g.motion_x.at(x, y), 1e-3);
      EXPECT_NEAR(backward.at(1, x, y), g.motion_y.at(x, y), 1e-3);
      const float to_x = static_cast<float>(x) + forward.at(0, x, y);
      const float to_y = static_cast<float>(y) + forward.at(1, x, y);
      if (to_x < 0 || to_y < 0 || to_x >= kW - 1 || to_y >= kH - 1 || forward.at(2, x, y) == 0) continue;
      ++valid;
      consistent += std::abs(forward.at(0, x, y) + sampled(backward, 0, to_x, to_y)) < 0.05f &&
                    std::abs(forward.at(1, x, y) + sampled(backward, 1, to_x, to_y)) < 0.05f;
    }
  }
  EXPECT_GT(valid, kW * kH / 2);
  EXPECT_GT(consistent, 0.95 * valid);
}

TEST(TruthFlow, IsExactlyZeroAndValidWhereTheCameraStands) {
  TruthRun run(test::room()->description(), Trajectory({{TimeNs(0), Pose{{0, 0, -0.9}, {}}}}), kW, kH, 80);
  const FeedInterval interval = run.step();
  for (const char* name : {"flow_forward", "flow_backward"}) {
    const Planes flow = run.planesOf(run.source(name)->sample(interval).front());
    for (int y = 0; y < kH; ++y)
      for (int x = 0; x < kW; ++x)
        ASSERT_TRUE(flow.at(0, x, y) == 0 && flow.at(1, x, y) == 0 && flow.at(2, x, y) == 1) << name;
  }
}

// Forward flow of frame t comes with frame t + 1.
TEST(TruthFlow, HasTheTimeOfTheFrameWhosePixelsItShows) {
  TruthRun run(test::room()->description(), Trajectory({{TimeNs(0), Pose{}}}), kW, kH, 80);
  const auto forward = run.source("flow_forward"), backward = run.source("flow_backward");
  for (int t = 1; t <= 3; ++t) {
    const FeedInterval interval = run.step();
    const TruthSamples next = forward->sample(interval), before = backward->sample(interval);
    ASSERT_EQ(next.size(), 1u);
    ASSERT_EQ(before.size(), 1u);
    EXPECT_EQ(next.front().t_ns, ((t - 1) * kFrameTime).count());
    EXPECT_EQ(before.front().t_ns, (t * kFrameTime).count());
  }
}

}  // namespace
}  // namespace saccade
