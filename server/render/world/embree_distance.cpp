#include <algorithm>
#include <cmath>

#include "render/world/embree_query.h"
#include "render/world/embree_scene.h"
#include "render/world/triangle_distance.h"

namespace saccade {
namespace {

constexpr float kRoom = 1 + 1e-6f;  // of a radius, so that nothing nearer is lost to rounding

struct Search {
  const Scene& shapes;
  Vec3d point;
  double nearest;  // so far
};

// Embree calls this for triangles that may be nearer than the radius of the query.
bool lookAt(RTCPointQueryFunctionArguments* found) {
  Search& search = *static_cast<Search*>(found->userPtr);
  if (found->geomID >= search.shapes.meshes.size()) return false;
  const Mesh& mesh = search.shapes.meshes[found->geomID];
  const auto corner = [&](std::uint32_t i) { return toDouble(mesh.positions[i]); };
  const auto [a, b, c] = mesh.triangles[found->primID];
  const double distance = triangleDistance(search.point, corner(a), corner(b), corner(c));
  if (!(distance < search.nearest)) return false;
  search.nearest = distance;
  found->query->radius = static_cast<float>(distance) * kRoom;
  return true;
}

}  // namespace

// Embree's query knows triangles alone.
double EmbreeScene::distance(Vec3d point, double reach) const {
  Search search{shapes_, point, reach};
  for (const Sphere& s : shapes_.spheres)
    if (s.body == kStands)
      search.nearest = std::min(search.nearest,
                                std::abs(length(point - toDouble(s.center)) - static_cast<double>(s.radius)));
  const Vec3 p = toFloat(point);
  RTCPointQuery query{p.x, p.y, p.z, 0, static_cast<float>(std::min(search.nearest, 1e30)) * kRoom};
  RTCPointQueryContext context;
  rtcInitPointQueryContext(&context);
  rtcPointQuery(scene_, &query, &context, lookAt, &search);
  return search.nearest;
}

}  // namespace saccade
