// The bodies of a scene at one time.
#pragma once

#include <memory>
#include <span>
#include <vector>

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
  // The place of a surface of a body in caches of light: as the scene file has it, but apart from all others.
  Vec3 cachePlace(std::uint32_t body, Vec3 point) const {
    Vec3 place = motions_[body].restPoint(point);
    place.x += apart_ * static_cast<float>(body + 1);
    return place;
  }

  // A number for all poses, joined with `other`.
  std::uint64_t state(std::uint64_t other) const;

  const EmbreeInstances& all() const { return all_; }
  const EmbreeInstances& emitters() const { return emitters_; }
  const EmbreeInstances& straight() const { return straight_; }
  const PosedLamps* lamps() const { return lamps_.get(); }  // nullptr where all lamps stand

 private:
  const RenderScene& scene_;
  std::vector<Trajectory> paths_;
  std::vector<Pose> poses_;  // world axes
  std::vector<RigidMotion> motions_;
  EmbreeInstances all_, emitters_, straight_;
  std::unique_ptr<PosedLamps> lamps_;
  float apart_;  // twice the size of the scene
};

}  // namespace saccade
