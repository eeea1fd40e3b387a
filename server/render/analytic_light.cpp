#include "render/analytic_light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "base/wide.h"

namespace saccade {
namespace {

constexpr std::size_t kMaxSides = 16;  // more cost more than their shadows tell
constexpr std::size_t kMaxCorners = 8;

struct Polygon {
  std::array<Vec3, kMaxCorners> corners;
  std::size_t count = 0;
  void add(Vec3 v) {
    if (count < kMaxCorners) corners[count++] = v;
  }
};

// The part of a polygon, seen from the origin, that is above the plane with normal n.
Polygon above(const Polygon& in, Vec3 n) {
  bool all = true;
  for (std::size_t i = 0; i < in.count; ++i) all = all && dot(in.corners[i], n) > 0;
  if (all) return in;
  Polygon out;
  for (std::size_t i = 0; i < in.count; ++i) {
    const Vec3 a = in.corners[i], b = in.corners[i + 1 < in.count ? i + 1 : 0];
    const float height_a = dot(a, n), height_b = dot(b, n);
    if (height_a > 0) out.add(a);
    if ((height_a > 0) != (height_b > 0)) out.add(a + (b - a) * (height_a / (height_a - height_b)));
  }
  return out;
}

// angle / sin(angle) of an angle with this cosine, to 5e-7: a polynomial fitted to acos(c) / sqrt(1 - c^2) on
// [0, 1].
template <class F>
F angleOverSine(F cosine) {
  using std::abs, std::max, std::sqrt;
  const F c = abs(cosine);
  F f = -0.02735403f;
  for (const float k : {0.1384896f, -0.327471f, 0.5115087f, -0.6495042f, 0.7834481f, -0.9999133f, 1.570796f})
    f = f * c + k;
  return select(cosine >= 0.f, f, F(std::numbers::pi_v<float> / sqrt(max(F(1e-12f), 1.f - c * c)) - f));
}

// Share of the cosine-weighted hemisphere about n that a polygon above the horizon covers [Lambert 1760].
float formFactor(const Polygon& polygon, Vec3 n) {
  std::array<Vec3, kMaxCorners> unit;
  for (std::size_t i = 0; i < polygon.count; ++i) unit[i] = normalize(polygon.corners[i]);
  float sum = 0;
  for (std::size_t i = 0; i < polygon.count; ++i) {
    const Vec3 a = unit[i], b = unit[i + 1 < polygon.count ? i + 1 : 0];
    sum += angleOverSine(dot(a, b)) * dot(n, cross(a, b));
  }
  return std::abs(sum) * (0.5f * std::numbers::inv_pi_v<float>);
}

constexpr int kLanes = 8;
using F = Floats<kLanes>;

// Eight points.
struct SeenFrom {
  SeenFrom(const LitPoints& points, int first)
      : point(points.point.lanes<kLanes>(first)),
        normal(points.normal.lanes<kLanes>(first)),
        geometric_normal(points.geometric_normal.lanes<kLanes>(first)) {}
  Vec3T<F> point, normal, geometric_normal;
};

struct FormFactors {
  F factor;            // of points that see all of a polygon
  Mask<kLanes> whole;  // those points
  std::uint32_t cut;   // points that see a part of it
};

FormFactors formFactors(const std::vector<Vec3>& corners, Vec3 lit, const SeenFrom& p) {
  std::array<Vec3T<F>, 4> unit;
  const auto front = dot(p.point - splat<F>(corners[0]), splat<F>(lit)) > 0.f;
  auto all = front;
  Mask<kLanes> any(false), any_geometric(false);  // corners above the horizon
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3T<F> w = splat<F>(corners[i]) - p.point;
    const auto above = dot(w, p.normal) > 0.f, above_geometric = dot(w, p.geometric_normal) > 0.f;
    all = all && above && above_geometric;
    any = any || above, any_geometric = any_geometric || above_geometric;
    unit[i] = w * F(1.f / sqrt(dot(w, w)));
  }
  F sum = 0.f;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3T<F>&a = unit[i], &b = unit[i + 1 < corners.size() ? i + 1 : 0];
    sum += angleOverSine<F>(dot(a, b)) * dot(p.normal, cross(a, b));
  }
  return {F(abs(sum) * (0.5f * std::numbers::inv_pi_v<float>)), all,
          bitsOf(front && any && any_geometric && !all)};
}

// Whether the second triangle goes on where the first ends, in its plane: (a, b, c) and (a, c, d), as of a
// rectangle.
bool isQuad(const Mesh& mesh, std::size_t i) {
  if (i + 1 >= mesh.triangles.size()) return false;
  const auto &s = mesh.triangles[i], &t = mesh.triangles[i + 1];
  if (t[0] != s[0] || t[1] != s[2]) return false;
  const auto normal = [&](const auto& v) {
    return cross(mesh.positions[v[1]] - mesh.positions[v[0]], mesh.positions[v[2]] - mesh.positions[v[0]]);
  };
  const Vec3 m = normal(s), n = normal(t);
  return dot(m, n) > 0.99999f * length(m) * length(n);
}

}  // namespace

AnalyticLight::AnalyticLight(const Scene& scene)
    : held_(scene.meshes.size()),
      point_lights_(scene.point_lights),
      directional_lights_(scene.directional_lights) {
  for (std::size_t i = 0; i < scene.meshes.size(); ++i) {
    const Mesh& mesh = scene.meshes[i];
    if (emits(mesh) && sides_.size() + mesh.triangles.size() <= kMaxSides)
      addSides(mesh, static_cast<std::uint32_t>(i));
  }
}

void AnalyticLight::addSides(const Mesh& mesh, std::uint32_t geometry) {
  held_[geometry] = true;
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto [a, b, c] = mesh.triangles[i];
    Side side{{mesh.positions[a], mesh.positions[b], mesh.positions[c]}, {}, mesh.radiance, geometry};
    const Vec3 normal = cross(side.corners[1] - side.corners[0], side.corners[2] - side.corners[0]);
    if (dot(normal, normal) == 0) continue;
    side.normal = normalize(normal);
    if (isQuad(mesh, i)) side.corners.push_back(mesh.positions[mesh.triangles[++i][2]]);
    sides_.push_back(std::move(side));
  }
}

Rgb AnalyticLight::from(const Side& side, const LitPoint& p, float strength) {
  if (dot(p.point - side.corners[0], side.normal) <= 0) return {};
  Polygon seen;
  for (const Vec3 corner : side.corners) seen.add(corner - p.point);
  seen = above(seen, p.normal);
  if (!(p.normal == p.geometric_normal)) seen = above(seen, p.geometric_normal);
  return side.radiance * (formFactor(seen, p.normal) * strength);
}

Rgb AnalyticLight::fromPointsAndDirections(const LitPoint& p) const {
  Rgb sum;
  const auto addFrom = [&](Vec3 w, Rgb irradiance) {
    if (dot(w, p.geometric_normal) <= 0) return;
    sum = sum + irradiance * (std::max(0.f, dot(w, p.normal)) * std::numbers::inv_pi_v<float>);
  };
  for (const PointLight& l : point_lights_) {
    const Vec3 segment = l.position - p.point;
    const float distance2 = dot(segment, segment);
    addFrom(segment / std::sqrt(distance2), l.intensity / distance2);
  }
  for (const DirectionalLight& l : directional_lights_) addFrom(-l.direction, l.irradiance);
  return sum;
}

Rgb AnalyticLight::at(const LitPoint& p, const EmitterStrengths& strengths) const {
  Rgb sum = fromPointsAndDirections(p);
  for (const Side& side : sides_) sum = sum + from(side, p, strengths[side.geometry]);
  return sum;
}

void AnalyticLight::at(const LitPoints& points, std::uint32_t lanes, const EmitterStrengths& strengths,
                       LaneVectors& result) const {
  if (!point_lights_.empty() || !directional_lights_.empty())
    forEachLane(lanes, [&](int i) { result.set(i, fromPointsAndDirections(points.at(i))); });
  else
    result = {};
  for (int first = 0; first < kLaneVectors; first += kLanes) {
    const std::uint32_t here = lanes >> first & ((1u << kLanes) - 1);
    if (here == 0) continue;
    const SeenFrom lane_points(points, first);
    for (const Side& side : sides_) {
      const auto [factor, whole, cut] = formFactors(side.corners, side.normal, lane_points);
      const float strength = strengths[side.geometry];
      const F light = select(whole, F(factor * strength), F(0.f));
      result.store(result.lanes<kLanes>(first) + splat<F>(side.radiance) * light, first);
      forEachLane(cut & here, [&](int i) {
        const int lane = first + i;
        result.set(lane, result.at(lane) + from(side, points.at(lane), strength));
      });
    }
  }
}

}  // namespace saccade
