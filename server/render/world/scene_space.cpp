#include "render/world/scene_space.h"

#include <limits>
#include <vector>

#include "render/world/coherent_rays.h"

namespace saccade {

double SceneSpace::distance(Vec3d point, double reach) const {
  return scene_.geometry().distance(inScene(point), reach);
}

void SceneSpace::look(Vec3d from, std::span<const Vec3d> directions, std::span<double> distances) const {
  const Vec3 origin = toFloat(inScene(from));
  std::vector<Ray> rays;
  for (const Vec3d along : directions)
    rays.push_back({origin, toFloat(along), std::numeric_limits<float>::infinity()});
  std::vector<Hit> hits(rays.size());
  intersectCoherent(scene_.geometry(), rays, hits);
  for (std::size_t i = 0; i < hits.size(); ++i)
    distances[i] = hits[i].valid ? static_cast<double>(hits[i].t) : std::numeric_limits<double>::infinity();
}

}  // namespace saccade
