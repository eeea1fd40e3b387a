// A camera at a pose in the axes of a scene, see RenderScene::inScene(). Directions have length 1 along the
// viewing axis. So the t of a hit is its depth z.
#pragma once

#include <cmath>

#include "base/check.h"
#include "scene/camera/lens.h"
#include "scene/camera/pose.h"

namespace saccade {

class Camera {
 public:
  // Without distortion.
  Camera(const Pose& T_scene_camera, const CameraModel& model) : Camera(T_scene_camera, model, nullptr) {
    SACCADE_CHECK(model.distortion.isNone());
  }
  // `lens` must outlive the camera.
  Camera(const Pose& T_scene_camera, const Lens& lens)
      : Camera(T_scene_camera, lens.camera(), lens.isDistorted() ? &lens : nullptr) {}

  // Moves the grid of pixels over the picture by less than a pixel.
  void shift(float x, float y) { cx_ += x, cy_ += y, shift_.x += x, shift_.y += y; }

  // The point that is shown at (x, y) in pixels, in the plane at distance 1. Pixel centres are whole numbers.
  Vec2 planePoint(float x, float y) const {
    if (lens_) return lens_->planePoint(x - shift_.x, y - shift_.y);
    return {(x - cx_) * pixel_x_, (y - cy_) * pixel_y_};
  }
  // The direction through the same point.
  Vec3 direction(float x, float y) const {
    const Vec2 p = planePoint(x, y);
    return forward + right * p.x + down * p.y;
  }
  // The same in lanes, where there is no distortion.
  template <class F>
  [[gnu::always_inline]] Vec3T<F> plainDirection(const F& x, const F& y) const {
    const F px = (x - cx_) * pixel_x_, py = (y - cy_) * pixel_y_;
    return splat<F>(forward) + splat<F>(right) * px + splat<F>(down) * py;
  }

  template <class F>
  struct ProjectionT {
    F x, y;  // pixels
    F z;     // depth; x and y are valid only where z is positive
  };
  using Projection = ProjectionT<float>;
  Projection project(Vec3 point) const { return projectDirection(point - origin); }
  // Projects the point at infinity in a direction.
  Projection projectDirection(Vec3 d) const { return lens_ ? throughLens(d) : projectPlain(d); }
  // The same where there is no distortion, of one direction or of lanes: without a branch, which would change
  // how compilers round.
  template <class F>
  [[gnu::always_inline]] ProjectionT<F> projectPlain(const Vec3T<F>& d) const {
    const F z = dot(d, splat<F>(forward)), scale = 1.f / (z * pixel_x_);
    return {dot(d, splat<F>(right)) * scale + cx_, dot(d, splat<F>(down)) * (scale * aspect_) + cy_, z};
  }

  bool isPlain() const { return !lens_; }  // without distortion

  // The width of a pixel at z = 1: the geometric mean of both axes. `direction` is that of a ray.
  float pixelAt(Vec3 direction) const { return lens_ ? pixelThroughLens(direction) : pixel; }

  // `direction` of a ray, moved by one pixel to the right, or down, to first order.
  Vec3 nextRight(Vec3 direction) const {
    if (lens_) return nextThroughLens(direction, {1, 0});
    return nextRightPlain(direction);
  }
  Vec3 nextDown(Vec3 direction) const {
    if (lens_) return nextThroughLens(direction, {0, 1});
    return nextDownPlain(direction);
  }
  // The same where there is no distortion, of one direction or of lanes.
  template <class F>
  [[gnu::always_inline]] Vec3T<F> nextRightPlain(const Vec3T<F>& direction) const {
    return direction + splat<F>(right * pixel_x_);
  }
  template <class F>
  [[gnu::always_inline]] Vec3T<F> nextDownPlain(const Vec3T<F>& direction) const {
    return direction + splat<F>(down * pixel_y_);
  }

  Vec3 origin, right, down, forward;
  float pixel;  // the same on the viewing axis

 private:
  Camera(const Pose& T_scene_camera, const CameraModel& model, const Lens* lens);

  Projection throughLens(Vec3 d) const;
  float pixelThroughLens(Vec3 direction) const;
  Vec3 nextThroughLens(Vec3 direction, Vec2 pixels) const;

  float pixel_x_, pixel_y_;  // width and height of a pixel at z = 1, without distortion
  float aspect_;             // fy over fx
  float cx_, cy_;            // the principal point, pixels
  const Lens* lens_;         // nullptr without distortion
  Vec2 shift_;               // of shift()
};

}  // namespace saccade
