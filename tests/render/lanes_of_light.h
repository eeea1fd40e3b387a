// Direct light of many points at once, against that of each.
#pragma once

#include <gtest/gtest.h>

#include <cmath>

#include "render/lights/analytic_light.h"

namespace saccade::test {

// Points at x(i), some of whose normals are not those of their surface. More than `least` of them are
// brighter than `bright`.
inline void expectTheSameInLanes(const Scene& scene, const auto& x, float bright, int least) {
  const AnalyticLight light(scene);
  const EmitterStrengths strengths(scene);
  LaneVectors point, normal, geometric_normal, together;
  int lit = 0;
  for (int i = 0; i < kLaneVectors; ++i) {
    const auto k = static_cast<float>(i);
    const Vec3 n = normalize(Vec3{std::cos(0.7f * k), std::sin(0.7f * k), 0.5f});
    point.set(i, {x(k), std::sin(0.7f * k), 0.08f * k - 0.5f}), normal.set(i, n);
    geometric_normal.set(i, i % 3 == 0 ? n : normalize(n + Vec3{0.2f, 0, 0}));
  }
  const LitPoints points{point, normal, geometric_normal};
  light.at(points, {0x7fff}, strengths, together);
  for (int i = 0; i < kLaneVectors - 1; ++i) {
    const float one = luminance(light.at(points.at(i), strengths));
    EXPECT_NEAR(luminance(together.at(i)), one, 1e-5f * (1 + one)) << i;
    lit += one > bright;
  }
  EXPECT_GT(lit, least);
}

}  // namespace saccade::test
