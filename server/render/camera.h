// Pinhole camera with square pixels. Directions have length 1 along the viewing axis. So the t of a hit is
// its depth z.
#pragma once

#include <cmath>
#include <numbers>

#include "scene/camera/pose.h"

namespace saccade {

struct Camera {
  Camera(const Pose& T_world_camera, double fov_x_deg, int width, int height)
      : origin(toFloat(T_world_camera.position)),
        right(toFloat(rotate(T_world_camera.rotation, {1, 0, 0}))),
        down(toFloat(rotate(T_world_camera.rotation, {0, 1, 0}))),
        forward(toFloat(rotate(T_world_camera.rotation, {0, 0, 1}))),
        pixel(static_cast<float>(2 * std::tan(fov_x_deg * std::numbers::pi / 360) / width)),
        cx(0.5f * static_cast<float>(width - 1)),
        cy(0.5f * static_cast<float>(height - 1)) {}

  // The direction through the point (x, y) in pixels. Pixel centres are whole numbers.
  Vec3 direction(float x, float y) const {
    return forward + right * ((x - cx) * pixel) + down * ((y - cy) * pixel);
  }

  struct Projection {
    float x, y;  // pixels
    float z;     // depth; x and y are valid only where z is positive
  };
  Projection project(Vec3 point) const { return projectDirection(point - origin); }
  // Projects the point at infinity in a direction.
  Projection projectDirection(Vec3 d) const {
    const float z = dot(d, forward), scale = 1 / (z * pixel);
    return {dot(d, right) * scale + cx, dot(d, down) * scale + cy, z};
  }

  Vec3 origin, right, down, forward;
  float pixel;   // width of a pixel at z = 1
  float cx, cy;  // the principal point, pixels
};

}  // namespace saccade
