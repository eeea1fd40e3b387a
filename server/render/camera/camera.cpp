#include "render/camera/camera.h"

namespace saccade {

Camera::Camera(const Pose& T_scene_camera, const CameraModel& model, const Lens* lens)
    : origin(toFloat(T_scene_camera.position)),
      right(toFloat(rotate(T_scene_camera.rotation, {1, 0, 0}))),
      down(toFloat(rotate(T_scene_camera.rotation, {0, 1, 0}))),
      forward(toFloat(rotate(T_scene_camera.rotation, {0, 0, 1}))),
      pixel(static_cast<float>(1 / model.focal())),
      pixel_x_(static_cast<float>(1 / model.fx)),
      pixel_y_(static_cast<float>(1 / model.fy)),
      aspect_(static_cast<float>(model.fy / model.fx)),
      cx_(static_cast<float>(model.cx)),
      cy_(static_cast<float>(model.cy)),
      lens_(lens) {}

Camera::Projection Camera::throughLens(Vec3 d) const {
  const double z = dot(d, forward);
  const PlanePoint at = lens_->pixelOf({dot(d, right) / z, dot(d, down) / z});
  return {static_cast<float>(at.x) + shift_.x, static_cast<float>(at.y) + shift_.y, static_cast<float>(z)};
}

float Camera::pixelThroughLens(Vec3 direction) const {
  const PlaneMap slope = lens_->pixelSlope({dot(direction, right), dot(direction, down)});
  return static_cast<float>(1 / std::sqrt(slope.determinant()));
}

Vec3 Camera::nextThroughLens(Vec3 direction, Vec2 pixels) const {
  const PlaneMap slope = lens_->pixelSlope({dot(direction, right), dot(direction, down)});
  const double x = (slope.yy * pixels.x - slope.xy * pixels.y) / slope.determinant();
  const double y = (slope.xx * pixels.y - slope.yx * pixels.x) / slope.determinant();
  return direction + right * static_cast<float>(x) + down * static_cast<float>(y);
}

}  // namespace saccade
