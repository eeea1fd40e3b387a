// Specific force and angular velocity of the body.
#include <array>

#include "base/tile_pool.h"
#include "truth/imu/imu_motion.h"
#include "truth/imu/imu_noise.h"
#include "truth/truth_source.h"

namespace saccade {
namespace {

// Sample k = 1, 2, ... has the time of a frame k at the rate of the IMU.
class ImuSource final : public TruthSource {
 public:
  explicit ImuSource(const ImuConfig& config) : config_(config), noise_(config) {}

  TruthSamples sample(const FeedInterval& interval) override {
    if (next_ == 0) next_ = firstAfter(interval.change.t0);
    TruthSamples samples;
    for (; timeOf(next_) <= interval.change.t1; ++next_) {
      samples.push_back(at(interval.rendered->path, next_));
      TilePool::yieldToHighPriority();
    }
    return samples;
  }

 private:
  TimeNs timeOf(std::uint64_t k) const { return frameTime(k, config_.rate_hz); }

  std::uint64_t firstAfter(TimeNs t) const {
    auto k = static_cast<std::uint64_t>(seconds(t) * config_.rate_hz);
    while (timeOf(k) <= t) ++k;
    return k;
  }

  TruthSample at(const Trajectory& path, std::uint64_t k) {
    const ImuReading exact = imuReading(path, timeOf(k - 1), timeOf(k), config_);
    const ImuReading noise = noise_.at(k);
    const Vec3d a = exact.force + noise.force, g = exact.rate + noise.rate;
    const std::array row{a.x, a.y, a.z, g.x, g.y, g.z};
    return {timeOf(k).count(), std::string(reinterpret_cast<const char*>(row.data()), sizeof row)};
  }

  ImuConfig config_;
  ImuNoise noise_;
  std::uint64_t next_ = 0;  // 0: before the first interval
};

}  // namespace

std::unique_ptr<TruthSource> makeImu(const TruthConfig& config) {
  return std::make_unique<ImuSource>(config.imu);
}

}  // namespace saccade
