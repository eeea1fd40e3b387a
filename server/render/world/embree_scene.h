// Shapes of a scene in Embree.
#pragma once

#include "render/world/embree_tracer.h"
#include "scene/scene.h"

namespace saccade {

// Geometry ids count the meshes in the order of Scene::meshes, then the spheres. Keeps pointers into the
// shapes of `scene`.
class EmbreeScene : public EmbreeTracer {
 public:
  // kEmitters: only those that emit. kStraight: only those that let some light straight through. The ids
  // stay.
  enum class Shapes { kAll, kEmitters, kStraight };
  // The shapes that stand.
  explicit EmbreeScene(const Scene& scene, Shapes shapes = Shapes::kAll)
      : EmbreeScene(scene, shapes, kStands, std::make_shared<EmbreeDevice>()) {}
  // The shapes of a body, in the places that the scene file gives them. kChanges: the positions of meshes
  // that deform may change before update().
  enum class Form { kKept, kChanges };
  EmbreeScene(const Scene& scene, Shapes shapes, int body, std::shared_ptr<EmbreeDevice> device,
              Form form = Form::kKept);

  // Takes milliseconds for 100,000 triangles. Not while rays are traced.
  void update();

  // From a point to the nearest surface, or `reach` where none is nearer than that.
  double distance(Vec3d point, double reach) const;

  float diagonal() const { return diagonal_; }  // of the bounding box; 0: there is nothing
  std::size_t bytes() const { return device_->bytes(); }

 private:
  friend class EmbreeInstances;

  const Scene& shapes_;
  std::vector<unsigned> changing_;  // ids of meshes that deform
  float diagonal_;
};

}  // namespace saccade
