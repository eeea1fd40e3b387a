#include "scene/roam/clear.h"

#include <algorithm>

#include "scene/camera/spline_path.h"

namespace saccade {
namespace {

constexpr double kSlack = 0.05;  // of the clearance
constexpr int kMostSteps = 200, kMostHalvings = 8;

class Loop {
 public:
  Loop(const FreeSpace& space, const std::vector<Vec3d>& controls, double clearance)
      : space_(space), controls_(controls), clearance_(clearance) {}

  // A part of the curve that is `part` long in u. The distance changes by no more than the way along the
  // curve.
  bool isClear(double middle, double part, double speed, int halvings = 0) const {
    const double way = speed * part / 2;
    const double distance = space_.distance(loopAt(controls_, middle), clearance_ + way);
    if (distance < clearance_) return false;
    if (distance >= clearance_ + way || way <= kSlack * clearance_) return true;
    if (halvings == kMostHalvings) return false;
    return isClear(middle - part / 4, part / 2, speed, halvings + 1) &&
           isClear(middle + part / 4, part / 2, speed, halvings + 1);
  }

  // The greatest length of the derivative by u from control i to the next: it is a mean of the steps.
  double speedOf(std::size_t i) const {
    const std::size_t n = controls_.size();
    const auto step = [&](std::size_t k) { return length(controls_[(k + 1) % n] - controls_[k % n]); };
    return std::max({step(i + n - 1), step(i), step(i + 1)});
  }

 private:
  const FreeSpace& space_;
  const std::vector<Vec3d>& controls_;
  double clearance_;
};

}  // namespace

bool isClear(const FreeSpace& space, Vec3d from, Vec3d to, double clearance) {
  const double whole = length(to - from);
  double done = 0;
  for (int i = 0; i < kMostSteps; ++i) {
    const double left = whole - done;
    const double distance =
        space.distance(whole > 0 ? from + (to - from) * (done / whole) : from, left + clearance);
    if (distance < clearance) return false;
    if (distance >= left + clearance) return true;
    done = std::min(whole, done + std::max(distance - clearance, 2 * kSlack * clearance));
  }
  return false;
}

bool isLoopClear(const FreeSpace& space, const std::vector<Vec3d>& controls, double clearance) {
  const Loop loop(space, controls, clearance);
  for (std::size_t i = 0; i < controls.size(); ++i)
    if (!loop.isClear(static_cast<double>(i) + 0.5, 1, loop.speedOf(i))) return false;
  return true;
}

}  // namespace saccade
