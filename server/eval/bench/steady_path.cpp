#include "eval/bench/steady_path.h"

#include <algorithm>

namespace saccade::eval {
namespace {

constexpr TimeNs kStep{1'000'000};  // no motion turns back sooner

}  // namespace

Trajectory straightThrough(const Trajectory& motion, TimeNs at) {
  Pose early = motion.at(TimeNs{0}), late = early;
  const Vec3d way = (motion.at(kStep).position - early.position) * (seconds(at) / seconds(kStep));
  early.position = early.position - way;
  late.position = late.position + way;
  return Trajectory({{TimeNs{0}, early}, {2 * at, late}});
}

Trajectory turningThrough(const Trajectory& motion, TimeNs at) {
  const std::int64_t steps = at / kStep + 1;
  Pose early = motion.at(TimeNs{0}), late = early;
  const Pose forth = inverse(early) * motion.at(kStep), back = inverse(forth);
  std::vector<TimedPose> keys{{at, early}};
  for (std::int64_t k = 1; k <= steps; ++k) keys.push_back({at - k * kStep, early = early * back});
  std::reverse(keys.begin(), keys.end());
  for (std::int64_t k = 1; k <= steps; ++k) keys.push_back({at + k * kStep, late = late * forth});
  return Trajectory(std::move(keys));
}

}  // namespace saccade::eval
