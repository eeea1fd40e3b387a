// Bodies where they lie at one time, in Embree.
#pragma once

#include <span>
#include <vector>

#include "render/world/embree_scene.h"
#include "scene/motion/rigid_motion.h"

struct RTCGeometryTy;

namespace saccade {

// In hits, Hit::body counts the bodies in their order, and normals are those of the scene file's own place.
class EmbreeInstances : public EmbreeTracer {
 public:
  // They share one device, and outlive this. They have no place yet.
  explicit EmbreeInstances(const std::vector<const EmbreeScene*>& bodies);
  ~EmbreeInstances();

  // Takes microseconds for each. Not while rays are traced.
  void place(std::span<const RigidMotion> motions);

 private:
  std::vector<RTCGeometryTy*> instances_;
};

}  // namespace saccade
