#include "truth/flow.h"

#include <cmath>
#include <cstddef>
#include <vector>

#include "base/tile_pool.h"
#include "truth/shape_rays.h"

namespace saccade {
namespace {

struct Flow {
  float x, y;  // pixels
  float z;     // depth in the other frame
};

// Where on its body the surface is that a pixel shows. In mirrors, bodies that deform seem to keep their
// form.
ShapePoint placeOf(const FlowView& here, int x, int y) {
  const std::uint32_t body = here.g.body.at(x, y) - 1;
  if (!here.scene.bodies()->deforms(body)) return ShapePoint::ofBody(body);
  const ShapeRay ray{static_cast<float>(x), static_cast<float>(y)};
  Hit hit;
  meetShapes(here.scene, here.camera, {&ray, 1}, {&hit, 1});
  return hit.valid && hit.body == body ? hit : ShapePoint::ofBody(body);
}

// From the camera here to a point that a pixel shows, plus this: from the camera there to the same point of
// its body.
Vec3 stepOf(const FlowView& here, const FlowView& there, int x, int y, Vec3 from_here) {
  const Vec3 of_camera = here.camera.origin - there.camera.origin;
  if (!here.scene.bodies() || here.g.body.at(x, y) == 0) return of_camera;
  const Vec3 point = here.camera.origin + from_here;
  return here.scene.carried(placeOf(here, x, y), point, there.scene) - point + of_camera;
}

// The camera that stands gives exactly 0, because both projections use the same formula.
Flow flowAt(const FlowView& here, const FlowView& there, int x, int y) {
  const Vec3 direction = here.camera.direction(static_cast<float>(x), static_cast<float>(y));
  const float z = here.g.z.at(x, y);
  const bool far = z == kMissDepth;
  const Vec3 from_here = far ? direction : direction * z;
  const Vec3 from_there = far ? direction : from_here + stepOf(here, there, x, y, from_here);
  const Camera::Projection begin = here.camera.projectDirection(from_here);
  const Camera::Projection end = there.camera.projectDirection(from_there);
  if (!(end.z > 0)) return {0, 0, end.z};
  return {end.x - begin.x, end.y - begin.y, far ? kMissDepth : end.z};
}

bool isVisible(const GBuffer& here, int x, int y, const Flow& flow, const GBuffer& there) {
  const float px = static_cast<float>(x) + flow.x, py = static_cast<float>(y) + flow.y;
  const bool inside = px >= -0.5f && py >= -0.5f && px < static_cast<float>(there.z.width()) - 0.5f &&
                      py < static_cast<float>(there.z.height()) - 0.5f;
  if (!(flow.z > 0) || !inside) return false;
  const int qx = static_cast<int>(std::floor(px + 0.5f)), qy = static_cast<int>(std::floor(py + 0.5f));
  const float away = std::abs(px - static_cast<float>(qx)) + std::abs(py - static_cast<float>(qy));
  const float slope = std::max(here.dz.at(x, y), there.dz.at(qx, qy));
  return std::abs(there.z.at(qx, qy) - flow.z) <= kFlowDepthTolerance * flow.z + slope * away;
}

}  // namespace

std::string flowPlanes(const FlowView& here, const FlowView& there) {
  const int width = here.g.z.width(), height = here.g.z.height();
  const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  std::vector<float> planes(3 * pixels);
  float *to_x = planes.data(), *to_y = to_x + pixels, *to_valid = to_y + pixels;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const Flow flow = flowAt(here, there, x, y);
      *to_x++ = flow.x, *to_y++ = flow.y;
      *to_valid++ = isVisible(here.g, x, y, flow, there.g) ? 1.0f : 0.0f;
    }
    TilePool::yieldToHighPriority();
  }
  return {reinterpret_cast<const char*>(planes.data()), planes.size() * sizeof(float)};
}

}  // namespace saccade
