#include "render/world/render_scene.h"

#include <algorithm>

#include "render/world/sight_samples.h"
#include "scene/scene_hash.h"
#include "scene/scene_stats.h"

namespace saccade {

RenderScene::RenderScene(Scene scene)
    : scene_(std::move(scene)),
      geometry_(scene_),
      emitters_(scene_, EmbreeScene::Shapes::kEmitters),
      straight_(scene_, EmbreeScene::Shapes::kStraight),
      lights_(scene_),
      analytic_light_(scene_),
      delta_lamps_(scene_, lights_.lamps()),
      light_columns_(lights_.lamps(), analytic_light_),
      shape_rows_(saccade::shapeRows(scene_)),
      shading_(shadingOf(scene_)),
      channels_(colorChannels(scene_)),
      has_straight_transmission_(
          std::any_of(scene_.materials.begin(), scene_.materials.end(), transmitsStraight)) {
  addBodies();
  for (const Material& m : scene_.materials) tables_.emplace_back(m.model);
  for (const LightSet set : {LightSet::kAll, LightSet::kWithExtent})
    if (lights_.lamps().hasTree(set))
      lights_.look(set, LampSight(sightSamples(lights_.lamps(), set, geometry_, shape_rows_)));
}

void RenderScene::addBodies() {
  if (scene_.bodies.empty()) return;
  device_of_bodies_ = std::make_shared<EmbreeDevice>();
  using Shapes = EmbreeScene::Shapes;
  for (int body = 0; body < static_cast<int>(scene_.bodies.size()); ++body) {
    const auto shapes = [&](Shapes kind) { return EmbreeScene(scene_, kind, body, device_of_bodies_); };
    bodies_.emplace_back(
        new BodyShapes{shapes(Shapes::kAll), shapes(Shapes::kEmitters), shapes(Shapes::kStraight)});
  }
}

std::uint64_t RenderScene::digest() const {
  std::call_once(hashed_, [&] { digest_ = hashScene(scene_); });
  return digest_;
}

std::size_t RenderScene::bytes() const {
  const SceneStats stats = statsOf(scene_);
  const std::size_t of_bodies = device_of_bodies_ ? device_of_bodies_->bytes() : 0;
  return stats.geometry_bytes + geometry_.bytes() + emitters_.bytes() + straight_.bytes() + of_bodies +
         stats.texture_bytes;
}

Obstacles::Hits RenderScene::find(const ProbeRays& rays) const {
  RayPacket<kRays> packet(kBlockingMask);
  for (int i = 0; i < kRays; ++i) packet.set(i, {rays[i].from, rays[i].along, rays[i].reach});
  geometry_.intersect(packet, LaneSet::first(kRays), EmbreeTracer::Rays::kScattered);
  Hits met;
  for (int i = 0; i < kRays; ++i)
    if (const Hit hit = packet.hit(i); hit.valid) met[i] = {hit.t, normalize(hit.normal)};
  return met;
}

}  // namespace saccade
