// How far shadows move in the picture of a feed, where bodies cast them, catch them or carry lamps [ours].
//
// The line from a lamp l through a point p meets the plane of a surface: there lies the shadow of p. All
// three move with their bodies.
#pragma once

#include <span>
#include <vector>

#include "feed/lamp_places.h"
#include "render/camera/camera.h"
#include "render/world/posed_scene.h"

namespace saccade {

// A surface that the picture shows.
struct ViewedPoint {
  BodyPoint point;
  Vec3 rest_normal;  // unit, towards the camera; of a body as the file has it
  Camera::Projection at;
};

class ShadowMotion {
 public:
  // `width`, `height`: of the picture, pixels. `most_points`: at a look().
  ShadowMotion(const Scene& scene, int width, int height, std::size_t most_points);

  // Finds shadows that may move, as the bodies of `scene` lie now. Traces a ray for each lamp and point.
  void look(std::span<const ViewedPoint> points, const PosedScene& scene);

  // Appends how far each has moved in the picture since the last call, or look(), in pixels. Those that were
  // beyond the picture, or behind the camera, are left out. `motions`: of the bodies.
  void appendSteps(const Camera& camera, std::span<const RigidMotion> motions, std::vector<float>& lengths);

 private:
  struct Shadow {
    BodyPoint lit;
    Vec3 rest_normal;
    BodyPoint caster, lamp;
    Camera::Projection at;
  };
  // Infinite where the light does not fall on the surface any more.
  static Vec3 placeOf(const Shadow& shadow, std::span<const RigidMotion> motions);
  void lookAt(const ViewedPoint& point, const LampPlace& lamp, const PosedScene& scene);

  bool shows(const Camera::Projection& at) const;

  float width_, height_;
  std::vector<LampPlace> lamps_;
  std::vector<Shadow> shadows_;
};

}  // namespace saccade
