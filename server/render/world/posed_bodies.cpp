#include "render/world/posed_bodies.h"

#include <algorithm>

#include "base/content_hash.h"
#include "scene/shape_box.h"

namespace saccade {
namespace {

std::vector<const EmbreeScene*> partsOf(const RenderScene& scene, EmbreeScene BodyShapes::*part) {
  std::vector<const EmbreeScene*> parts;
  for (const auto& body : scene.bodies()) parts.push_back(&((*body).*part));
  return parts;
}

bool isLampBody(const Scene& scene) {
  const auto moves = [](const auto& shape) { return shape.body != kStands && emits(shape); };
  return std::ranges::any_of(scene.meshes, moves) || std::ranges::any_of(scene.spheres, moves);
}

}  // namespace

PosedBodies::PosedBodies(const RenderScene& scene, const std::vector<Trajectory>& paths)
    : scene_(scene),
      paths_(paths),
      poses_(paths.size()),
      motions_(paths.size()),
      all_(partsOf(scene, &BodyShapes::all)),
      emitters_(partsOf(scene, &BodyShapes::emitters)),
      straight_(partsOf(scene, &BodyShapes::straight)) {
  const ShapeBox box = boxOf(scene.description());
  apart_ = 2 * length(box.high - box.low);
  if (isLampBody(scene.description()))
    lamps_ = std::make_unique<PosedLamps>(scene.description(), scene.lights());
}

void PosedBodies::setTime(TimeNs t) {
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    poses_[i] = paths_[i].at(t);
    motions_[i] = motionOf(scene_.description().bodies[i], scene_.inScene(poses_[i]));
  }
  all_.place(motions_), emitters_.place(motions_), straight_.place(motions_);
  if (lamps_) lamps_->place(scene_.description(), motions_);
}

std::uint64_t PosedBodies::state(std::uint64_t other) const {
  ContentHash h{other};
  for (const Pose& pose : poses_) h.add(pose.position), h.add(pose.rotation);
  return h.value;
}

}  // namespace saccade
