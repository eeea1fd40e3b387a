// The views from a place, in each direction that a camera may look.
#pragma once

#include <numbers>
#include <vector>

#include "scene/camera/free_space.h"
#include "scene/camera/lens.h"
#include "scene/roam/level.h"

namespace saccade {

// Distances that count as seen: neither the nose at a wall nor nearly the sky.
struct SeenRange {
  double nearest, farthest;
  bool has(double distance) const { return distance >= nearest && distance <= farthest; }
};

class Panorama {
 public:
  // Directions of view, kStep radians apart: all round, and as many up as down.
  static constexpr int kPans = 36, kTilts = 9;
  static constexpr double kStep = 2 * std::numbers::pi / kPans;
  static double panOf(int pan) { return pan * kStep; }
  static double tiltOf(int tilt) { return (tilt - kTilts / 2) * kStep; }

  Panorama(const FreeSpace& space, Vec3d place, const Level& level, const Lens& lens, const SeenRange& range);

  // Of the picture in this direction: the share that is seen, about.
  double share(int pan, int tilt) const { return at(pan, tilt).share; }
  // How far what it shows is from a plane, on average.
  double relief(int pan, int tilt) const { return at(pan, tilt).relief; }

  double bestShare() const;  // of all directions

 private:
  struct View {
    double share, relief;
  };
  const View& at(int pan, int tilt) const { return views_[static_cast<std::size_t>(tilt * kPans + pan)]; }

  std::vector<View> views_;
};

}  // namespace saccade
