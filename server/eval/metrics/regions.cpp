#include "eval/metrics/regions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "base/vec.h"
#include "eval/metrics/for_each_pixel.h"

namespace saccade::eval {
namespace {

Vec3 normalAt(const GBuffer& g, int x, int y) {
  return {g.nx.at(x, y), g.ny.at(x, y), g.nz.at(x, y)};
}

// By the chord between them.
bool alike(Vec3 a, Vec3 b, float degrees) {
  const float chord = 2 * std::sin(degrees * std::numbers::pi_v<float> / 360);
  return dot(a - b, a - b) <= chord * chord;
}

bool inside(const GBuffer& g, float x, float y) {
  return x >= 0 && y >= 0 && x < static_cast<float>(g.z.width()) && y < static_cast<float>(g.z.height());
}

bool changed(const GBuffer& cur, const GBuffer& prev, int x, int y) {
  const float was_x = static_cast<float>(x) + cur.motion_x.at(x, y);
  const float was_y = static_cast<float>(y) + cur.motion_y.at(x, y);
  const auto sameAt = [&](int qx, int qy) {
    const float distance =
        std::abs(static_cast<float>(qx) - was_x) + std::abs(static_cast<float>(qy) - was_y);
    const float tolerance = kSlopes * cur.dz.at(x, y) * distance + kDepthTolerance * cur.z.at(x, y);
    return std::abs(prev.z.at(qx, qy) - cur.z_in_prev.at(x, y)) <= tolerance &&
           alike(normalAt(cur, x, y), normalAt(prev, qx, qy), kSameNormalDeg);
  };
  const float nearest_x = std::floor(was_x + 0.5f), nearest_y = std::floor(was_y + 0.5f);
  return !inside(prev, nearest_x, nearest_y) ||
         !sameAt(static_cast<int>(nearest_x), static_cast<int>(nearest_y)) || !sameAt(x, y);
}

bool curved(const GBuffer& g, int x, int y) {
  const bool hit = g.z.at(x, y) < kMissDepth;
  for (int qy = std::max(y - 1, 0); qy <= std::min(y + 1, g.z.height() - 1); ++qy) {
    for (int qx = std::max(x - 1, 0); qx <= std::min(x + 1, g.z.width() - 1); ++qx) {
      if ((g.z.at(qx, qy) < kMissDepth) != hit) return true;
      if (!alike(normalAt(g, x, y), normalAt(g, qx, qy), kCurvedDeg)) return true;
    }
  }
  return false;
}

}  // namespace

RegionMap findRegions(const GBuffer& cur, const GBuffer& prev) {
  checkSameSize(cur.z, prev.z);
  RegionMap regions(cur.z.width(), cur.z.height());
  forEachPixel(regions, [&](int x, int y) {
    regions.at(x, y) = changed(cur, prev, x, y) ? region::kChanged
                       : curved(cur, x, y)      ? region::kCurved
                                                : region::kSmooth;
  });
  return regions;
}

double median(const ImageF& plane, const RegionMap& regions, std::uint32_t which) {
  checkSameSize(plane, regions);
  std::vector<float> values;
  forEachPixel(plane, [&](int x, int y) {
    if (regions.at(x, y) & which) values.push_back(plane.at(x, y));
  });
  const bool ordered = std::none_of(values.begin(), values.end(), [](float v) { return std::isnan(v); });
  if (values.empty() || !ordered) return std::numeric_limits<double>::quiet_NaN();
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (values.size() % 2 == 1) return *middle;
  return (static_cast<double>(*middle) + *std::max_element(values.begin(), middle)) / 2;
}

}  // namespace saccade::eval
