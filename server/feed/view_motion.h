// How far the picture of a feed will move.
#pragma once

#include <optional>
#include <vector>

#include "feed/shadow_motion.h"
#include "frame/frame.h"

namespace saccade {

class ViewMotion {
 public:
  // Takes the surfaces that `frame` shows on a grid of pixels, as `camera` and `scene` have made it.
  void look(const Frame& frame, const Camera& camera, const PosedScene& scene);

  // How far they move in the picture, and the shadows on them, since the last call, or look(): the 99th
  // percentile, in pixels. Leaves out what is behind the camera. Bodies lie where the paths of `scene` have
  // them at `t`. 0 where no surface is in view. Allocates nothing after the first look().
  double moveTo(TimeNs t, const Camera& camera, const PosedScene& scene);

 private:
  void place(TimeNs t, const PosedScene& scene);
  double shadowsMove(const Camera& camera);

  std::vector<ViewedPoint> points_, coarse_;  // coarse: for shadows
  std::vector<RigidMotion> motions_;          // of the bodies
  std::vector<float> lengths_;
  std::optional<ShadowMotion> shadows_;  // none in a scene without bodies
  bool bodies_rest_ = true;              // since look()
};

}  // namespace saccade
