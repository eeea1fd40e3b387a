#include "render/world/posed_bodies.h"

#include "base/content_hash.h"
#include "render/world/mesh_point.h"
#include "scene/motion/bodies.h"

namespace saccade {
PosedBodies::PosedBodies(const RenderScene& scene, const std::vector<Trajectory>& paths)
    : scene_(scene),
      paths_(paths),
      poses_(paths.size()),
      motions_(paths.size()),
      deformed_(anyDeforms(scene.description()) ? std::make_unique<DeformedShapes>(scene) : nullptr),
      all_(partsOf(&BodyShapes::all, &DeformedShapes::Trees::all)),
      emitters_(partsOf(&BodyShapes::emitters, nullptr)),
      straight_(partsOf(&BodyShapes::straight, &DeformedShapes::Trees::straight)) {
  const ShapeBox box = boxOf(scene.description());
  apart_ = 2 * length(box.high - box.low);
  if (anyLampMoves(scene.description()))
    lamps_ = std::make_unique<PosedLamps>(scene.description(), scene.lights());
}

std::vector<const EmbreeScene*> PosedBodies::partsOf(EmbreeScene BodyShapes::*part,
                                                     EmbreeScene DeformedShapes::Trees::*of_deformed) const {
  std::vector<const EmbreeScene*> parts;
  for (std::size_t i = 0; i < scene_.bodies().size(); ++i)
    parts.push_back(of_deformed && deforms(i) ? &(deformed_->trees(i)->*of_deformed)
                                              : &((*scene_.bodies()[i]).*part));
  return parts;
}

void PosedBodies::setTime(TimeNs t) {
  for (std::size_t i = 0; i < paths_.size(); ++i) {
    poses_[i] = paths_[i].at(t);
    motions_[i] = motionOf(scene_.description().bodies[i], scene_.inScene(poses_[i]));
  }
  if (deformed_) deformed_->setTime(t);
  all_.place(motions_), emitters_.place(motions_), straight_.place(motions_);
  if (lamps_) lamps_->place(scene_.description(), motions_);
}

std::uint64_t PosedBodies::state(std::uint64_t other) const {
  ContentHash h{other};
  for (const Pose& pose : poses_) h.add(pose.position), h.add(pose.rotation);
  return deformed_ ? deformed_->state(h.value) : h.value;
}

ShapeBox PosedBodies::box(std::size_t body) const {
  if (deforms(body)) return deformed_->box(body);
  const Body& rest = scene_.description().bodies[body];
  return {rest.low, rest.high};
}

bool PosedBodies::equals(const PosedBodies& other) const {
  return motions_ == other.motions_ && (!deformed_ || deformed_->equals(*other.deformed_));
}

bool PosedBodies::equals(const PosedBodies& other, std::size_t body) const {
  return motions_[body] == other.motions_[body] &&
         (!deforms(body) || deformed_->equals(*other.deformed_, body));
}

// Exactly the point where both motions and the vertices around it are equal.
Vec3 PosedBodies::carried(const ShapePoint& on, Vec3 point, const PosedBodies& to) const {
  const RigidMotion &here = motions_[on.body], &there = to.motions_[on.body];
  const Mesh* mesh = deformed_ ? deformed_->mesh(on.geometry) : nullptr;
  if (!mesh) return here == there ? point : there.point(here.restPoint(point));
  const Vec3 step = stepOn(*mesh, *to.deformed_->mesh(on.geometry), on);
  return here == there ? point + here.direction(step) : there.point(here.restPoint(point) + step);
}

Vec3 PosedBodies::turned(const ShapePoint& on, Vec3 direction, const PosedBodies& to) const {
  const Mesh* mesh = deformed_ ? deformed_->mesh(on.geometry) : nullptr;
  const Vec3 rest = motions_[on.body].restDirection(direction);
  return to.motions_[on.body].direction(mesh ? turnedWith(*mesh, *to.deformed_->mesh(on.geometry), on, rest)
                                             : rest);
}

Vec3 PosedBodies::cachePlace(const ShapePoint& on, Vec3 point) const {
  const Mesh* mesh = deformed_ ? deformed_->mesh(on.geometry) : nullptr;
  Vec3 place = motions_[on.body].restPoint(point);
  if (mesh) place = place + stepOn(*mesh, scene_.description().meshes[on.geometry], on);
  place.x += apart_ * static_cast<float>(on.body + 1);
  return place;
}

Vec3 PosedBodies::cacheNormal(const ShapePoint& on, Vec3 normal) const {
  const Mesh* mesh = deformed_ ? deformed_->mesh(on.geometry) : nullptr;
  const Vec3 rest = motions_[on.body].restDirection(normal);
  return mesh ? turnedWith(*mesh, scene_.description().meshes[on.geometry], on, rest) : rest;
}

}  // namespace saccade
