// The map between the pixels of a camera and the plane at distance 1 in front of it.
#pragma once

#include <string>
#include <vector>

#include "base/vec.h"
#include "scene/camera/distortion.h"

namespace saccade {

// Empty, or why no picture can be taken with this distortion. The lens may fold the picture, or parts of it
// lie too far from the viewing axis.
std::string lensFault(const CameraModel& camera);

class Lens {
 public:
  // Of a camera without lensFault().
  explicit Lens(const CameraModel& camera = {});

  const CameraModel& camera() const { return camera_; }
  bool isDistorted() const { return !camera_.distortion.isNone(); }

  // Solves planePoint() for all pixels, where there is distortion: 8 bytes each.
  void tabulate();

  // The point of the plane that the camera shows at (x, y) in pixels, which lies within a pixel of the
  // picture. Its image is there within 1e-4 pixels.
  Vec2 planePoint(float x, float y) const;

  // Where the camera shows a point of the plane, pixels. Around the picture too, while the lens does not fold
  // there, up to twice its size. Further out it goes on as a similarity, so that it never folds back.
  PlanePoint pixelOf(PlanePoint p) const;
  PlaneMap pixelSlope(PlanePoint p) const;  // of pixelOf(), within the picture

 private:
  PlanePoint shownAt(double x, double y) const {
    return {(x - camera_.cx) / camera_.fx, (y - camera_.cy) / camera_.fy};
  }

  CameraModel camera_;
  double reach_;             // of the formula, from the centre of the plane; further out, the similarity
  std::vector<Vec2> table_;  // by pixel, row by row; may be empty
};

}  // namespace saccade
