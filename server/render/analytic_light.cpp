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

struct LanePoints {
  explicit LanePoints(std::span<const LitPoint> points) {
    alignas(64) float of[9][kLanes] = {};
    for (std::size_t i = 0; i < points.size(); ++i) {
      const auto& [p, n, g] = points[i];
      int k = 0;
      for (const float c : {p.x, p.y, p.z, n.x, n.y, n.z, g.x, g.y, g.z}) of[k++][i] = c;
    }
    const auto vector = [&](int k) {
      return Vec3T<F>{load<kLanes>(of[k]), load<kLanes>(of[k + 1]), load<kLanes>(of[k + 2])};
    };
    point = vector(0), normal = vector(3), geometric_normal = vector(6);
  }
  Vec3T<F> point, normal, geometric_normal;
};

Vec3T<F> lanesOf(Vec3 v) {
  return {F(v.x), F(v.y), F(v.z)};
}

struct Seen {
  std::uint32_t whole, cut;  // points that see all of a polygon, or a part of it
};

// The form factors of a polygon that all points see from its lit side and whole.
Seen formFactors(const std::vector<Vec3>& corners, Vec3 lit, const LanePoints& p, float (&factor)[kLanes]) {
  std::array<Vec3T<F>, 4> unit;
  const auto front = dot(p.point - lanesOf(corners[0]), lanesOf(lit)) > 0.f;
  auto all = front;
  Mask<kLanes> any(false);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3T<F> w = lanesOf(corners[i]) - p.point;
    const auto seen = dot(w, p.normal) > 0.f && dot(w, p.geometric_normal) > 0.f;
    all = all && seen;
    any = any || dot(w, p.normal) > 0.f;
    unit[i] = w * F(1.f / sqrt(dot(w, w)));
  }
  F sum = 0.f;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3T<F>&a = unit[i], &b = unit[i + 1 < corners.size() ? i + 1 : 0];
    sum += angleOverSine<F>(dot(a, b)) * dot(p.normal, cross(a, b));
  }
  store(F(abs(sum) * (0.5f * std::numbers::inv_pi_v<float>)), factor);
  return {bitsOf(all), bitsOf(front && any && !all)};
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

void AnalyticLight::at(std::span<const LitPoint> points, const EmitterStrengths& strengths,
                       std::span<Rgb> results) const {
  for (std::size_t i = 0; i < results.size(); ++i) results[i] = fromPointsAndDirections(points[i]);
  for (std::size_t first = 0; first < results.size(); first += kLanes) {
    const int count = static_cast<int>(std::min<std::size_t>(kLanes, results.size() - first));
    const LanePoints lanes(points.subspan(first, static_cast<std::size_t>(count)));
    for (const Side& side : sides_) {
      alignas(64) float factor[kLanes];
      const auto [whole, cut] = formFactors(side.corners, side.normal, lanes, factor);
      const float strength = strengths[side.geometry];
      for (int i = 0; i < count; ++i) {
        Rgb& result = results[first + static_cast<std::size_t>(i)];
        if (whole >> i & 1) result = result + side.radiance * (factor[i] * strength);
        if (cut >> i & 1) result = result + from(side, points[first + static_cast<std::size_t>(i)], strength);
      }
    }
  }
}

}  // namespace saccade
