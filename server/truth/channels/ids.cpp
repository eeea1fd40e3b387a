// Which object and which material the ray through the pixel centre meets first.
#include <algorithm>
#include <array>
#include <span>
#include <vector>

#include "base/tile_pool.h"
#include "truth/object_numbers.h"
#include "truth/picture_source.h"
#include "truth/shape_rays.h"
#include "truth/truth_source.h"

namespace saccade {
namespace {

// Numbers count from 1 on; 0 is no surface.
struct Ids {
  std::uint32_t object = 0, material = 0;
};

class ShapeIds final : public PictureSource {
 public:
  using PictureSource::PictureSource;

 protected:
  std::string picture(const TruthFrame& frame) override {
    if (numbers_.empty()) numbers_ = objectNumbers(frame.rendered->scene.still().description());
    const int width = frame.intensity.width(), height = frame.intensity.height();
    constexpr int kStep = static_cast<int>(kShapeRays);
    std::vector<Ids> ids(static_cast<std::size_t>(width));
    std::string objects, materials;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; x += kStep)
        trace(*frame.rendered, x, y, std::span(ids).subspan(x, std::min(kStep, width - x)));
      for (const Ids& id : ids) append(id.object, objects), append(id.material, materials);
      TilePool::yieldToHighPriority();
    }
    return objects + materials;
  }

 private:
  Ids idsOf(const Scene& scene, const Hit& hit) const {
    if (!hit.valid) return {};
    const std::size_t shape = hit.geometry, meshes = scene.meshes.size();
    const int material =
        shape < meshes ? scene.meshes[shape].material : scene.spheres[shape - meshes].material;
    return {numbers_[shape], static_cast<std::uint32_t>(material) + 1};
  }

  // The numbers of the pixels from (x0, y) on.
  void trace(const RenderedFrame& frame, int x0, int y, std::span<Ids> out) const {
    std::array<ShapeRay, kShapeRays> rays;
    std::array<Hit, kShapeRays> hits;
    for (std::size_t i = 0; i < out.size(); ++i)
      rays[i] = {static_cast<float>(x0) + static_cast<float>(i), static_cast<float>(y)};
    meetShapes(frame.scene, frame.camera, std::span(rays).first(out.size()),
               std::span(hits).first(out.size()));
    for (std::size_t i = 0; i < out.size(); ++i) out[i] = idsOf(frame.scene.still().description(), hits[i]);
  }

  static void append(std::uint32_t id, std::string& plane) {
    plane.append(reinterpret_cast<const char*>(&id), sizeof id);
  }

  std::vector<std::uint32_t> numbers_;  // by shape, once the scene is known
};

}  // namespace

std::unique_ptr<TruthSource> makeIds(const TruthConfig& config) {
  return std::make_unique<ShapeIds>(config);
}

}  // namespace saccade
