// The bodies of a scene at one time.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "render/world/deformed_shapes.h"
#include "render/world/embree_instances.h"
#include "render/world/posed_lamps.h"
#include "render/world/render_scene.h"
#include "scene/camera/trajectory.h"

namespace saccade {

class PosedBodies {
 public:
  // `paths`: of the bodies of `scene`, in their order; at least one.
  PosedBodies(const RenderScene& scene, const std::vector<Trajectory>& paths);

  void setTime(TimeNs t);
  void append(std::size_t body, const TimedPose& key) { paths_[body].append(key); }

  const std::vector<Trajectory>& paths() const { return paths_; }
  // How they lie, in their order.
  std::span<const RigidMotion> motions() const { return motions_; }
  const DeformedShapes* deformed() const { return deformed_.get(); }  // nullptr where all keep their form
  bool deforms(std::size_t body) const { return deformed_ && deformed_->trees(body); }
  // Around a body in the place of the scene file.
  ShapeBox box(std::size_t body) const;

  bool equals(const PosedBodies& other) const;
  bool equals(const PosedBodies& other, std::size_t body) const;

  // Where a point of a body is at another time, and how a direction there has turned.
  Vec3 carried(const ShapePoint& on, Vec3 point, const PosedBodies& to) const;
  Vec3 turned(const ShapePoint& on, Vec3 direction, const PosedBodies& to) const;
  // The place of a surface of a body in caches of light, and its normal there. They are those of the scene
  // file, but apart from all others.
  Vec3 cachePlace(const ShapePoint& on, Vec3 point) const;
  Vec3 cacheNormal(const ShapePoint& on, Vec3 normal) const;

  // A number for all poses, joined with `other`.
  std::uint64_t state(std::uint64_t other) const;

  const EmbreeInstances& all() const { return all_; }
  const EmbreeInstances& emitters() const { return emitters_; }
  const EmbreeInstances& straight() const { return straight_; }
  const PosedLamps* lamps() const { return lamps_.get(); }  // nullptr where all lamps stand

 private:
  // `of_deformed`: nullptr where no mesh of this part deforms.
  std::vector<const EmbreeScene*> partsOf(EmbreeScene BodyShapes::*part,
                                          EmbreeScene DeformedShapes::Trees::*of_deformed) const;

  const RenderScene& scene_;
  std::vector<Trajectory> paths_;
  std::vector<Pose> poses_;  // world axes
  std::vector<RigidMotion> motions_;
  std::unique_ptr<DeformedShapes> deformed_;
  EmbreeInstances all_, emitters_, straight_;
  std::unique_ptr<PosedLamps> lamps_;
  float apart_;  // twice the size of the scene
};

}  // namespace saccade
