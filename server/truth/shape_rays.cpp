#include "truth/shape_rays.h"

#include <array>
#include <limits>

#include "base/check.h"
#include "render/world/coherent_rays.h"

namespace saccade {

void meetShapes(const PosedScene& scene, const Camera& camera, std::span<const ShapeRay> rays,
                std::span<Hit> hits) {
  SACCADE_CHECK(rays.size() <= kShapeRays && rays.size() == hits.size());
  std::array<Ray, kShapeRays> traced;
  for (std::size_t i = 0; i < rays.size(); ++i)
    traced[i] = {camera.origin, camera.direction(rays[i].x, rays[i].y),
                 std::numeric_limits<float>::infinity()};
  intersectCoherent(scene.geometry(), std::span(traced).first(rays.size()), hits);
}

}  // namespace saccade
