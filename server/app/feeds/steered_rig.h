// A rig whose paths its client steers.
#pragma once

#include <memory>

#include "app/feeds/steering.h"
#include "feed/rig.h"

namespace saccade {

class SteeredRig final : public Rig {
 public:
  // The paths of `rig` are steering->begin() and bodiesBegin(). They grow by a key for each frame.
  SteeredRig(Rig rig, std::shared_ptr<Steering> steering)
      : Rig(std::move(rig)), steering_(std::move(steering)) {}

  bool ready() const override { return !atFrame() || steering_->ready(); }
  const std::vector<FeedInterval>& step(const PoolHandle& pool) override {
    if (atFrame()) steer(steering_->next());
    return Rig::step(pool);
  }

 private:
  const std::shared_ptr<Steering> steering_;
};

}  // namespace saccade
