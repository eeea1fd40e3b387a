// Which shape and which material the ray through the pixel centre meets first.
#include <algorithm>
#include <array>
#include <limits>
#include <span>
#include <vector>

#include "base/tile_pool.h"
#include "render/world/coherent_rays.h"
#include "render/world/posed_scene.h"
#include "truth/picture_source.h"
#include "truth/truth_source.h"

namespace saccade {
namespace {

constexpr int kPacket = 16;  // rays at once

// Numbers count from 1 on; 0 is no surface.
struct Ids {
  std::uint32_t object = 0, material = 0;
};

Ids idsOf(const Scene& scene, const Hit& hit) {
  if (!hit.valid) return {};
  const std::size_t shape = hit.geometry, meshes = scene.meshes.size();
  const int material = shape < meshes ? scene.meshes[shape].material : scene.spheres[shape - meshes].material;
  return {hit.geometry + 1, static_cast<std::uint32_t>(material) + 1};
}

// Those of the pixels from (x0, y) on.
void trace(const RenderedFrame& frame, int x0, int y, std::span<Ids> out) {
  std::array<Ray, kPacket> rays;
  std::array<Hit, kPacket> hits;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const float x = static_cast<float>(x0) + static_cast<float>(i);
    rays[i] = {frame.camera.origin, frame.camera.direction(x, static_cast<float>(y)),
               std::numeric_limits<float>::infinity()};
  }
  intersectCoherent(frame.scene.geometry(), std::span(rays).first(out.size()),
                    std::span(hits).first(out.size()));
  for (std::size_t i = 0; i < out.size(); ++i) out[i] = idsOf(frame.scene.still().description(), hits[i]);
}

// The rays are those of the renderer.
class ShapeIds final : public PictureSource {
 public:
  using PictureSource::PictureSource;

 protected:
  std::string picture(const TruthFrame& frame) override {
    const int width = frame.intensity.width(), height = frame.intensity.height();
    std::vector<Ids> ids(static_cast<std::size_t>(width));
    std::string objects, materials;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; x += kPacket)
        trace(*frame.rendered, x, y, std::span(ids).subspan(x, std::min(kPacket, width - x)));
      for (const Ids& id : ids) append(id.object, objects), append(id.material, materials);
      TilePool::yieldToHighPriority();
    }
    return objects + materials;
  }

 private:
  static void append(std::uint32_t id, std::string& plane) {
    plane.append(reinterpret_cast<const char*>(&id), sizeof id);
  }
};

}  // namespace

std::unique_ptr<TruthSource> makeIds(const TruthConfig& config) {
  return std::make_unique<ShapeIds>(config);
}

}  // namespace saccade
