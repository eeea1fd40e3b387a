#include "render/render_scene.h"

#include <algorithm>

#include "scene/scene_stats.h"

namespace saccade {
namespace {

constexpr float kRelativeEpsilon = 2e-5f;  // of the scene's diagonal: some hundred ulps of its coordinates

bool isDiffuse(const Material& m) {
  return m.model.kind == BsdfKind::kDiffuse && isOpaque(m) && !isBumpy(m);
}

bool hasPassage(const Material& m) {
  return m.model.kind == BsdfKind::kThinDielectric || !isOpaque(m);
}

Shading leastShading(const Scene& s) {
  const auto& all = s.materials;
  const bool distant = s.environment || !s.point_lights.empty() || !s.directional_lights.empty();
  if (distant || !std::all_of(all.begin(), all.end(), isDiffuse)) return Shading::kAll;
  const bool textured =
      std::any_of(all.begin(), all.end(), [](const Material& m) { return isTextured(m.reflectance); });
  return textured ? Shading::kTexturedDiffuse : Shading::kDiffuse;
}

}  // namespace

RenderScene::RenderScene(Scene scene)
    : scene_(std::move(scene)),
      geometry_(scene_),
      lights_(scene_, geometry_.diagonal() / 2),
      shading_(leastShading(scene_)),
      channels_(colorChannels(scene_)),
      has_passages_(std::any_of(scene_.materials.begin(), scene_.materials.end(), hasPassage)),
      epsilon_(kRelativeEpsilon * geometry_.diagonal()) {
  if (shading_ == Shading::kAll)
    for (const Material& m : scene_.materials) tables_.emplace_back(m.model);
}

std::size_t RenderScene::bytes() const {
  const SceneStats stats = statsOf(scene_);
  return stats.geometry_bytes + geometry_.bytes() + stats.texture_bytes;
}

}  // namespace saccade
