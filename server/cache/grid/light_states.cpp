#include "cache/grid/light_states.h"

#include <algorithm>
#include <utility>

namespace saccade {

void LightStates::enter(std::uint64_t strengths, std::uint32_t frame) {
  previous_ = current_;
  current_ = &find(strengths);
  if (!previous_) previous_ = current_;
  current_->last_frame = frame, ++current_->frames;
}

LightState& LightStates::find(std::uint64_t strengths) {
  const auto known = std::ranges::find(states_, strengths, [](const auto& s) { return s->strengths; });
  if (known != states_.end()) return **known;
  if (states_.size() < kMost) {
    states_.push_back(std::make_unique<LightState>(
        LightState{strengths, SurfaceGrid(params_), SurfaceGrid(params_), BounceGrid(0)}));
    share();
    return *states_.back();
  }
  LightState& oldest = **std::ranges::min_element(states_, {}, [](const auto& s) { return s->last_frame; });
  oldest.grid.forget(), oldest.changes.forget(), oldest.bounces.forget();
  oldest.strengths = strengths, oldest.frames = 0;
  return oldest;
}

void LightStates::keepChanges() {
  if (std::exchange(keeps_changes_, true)) return;
  share();
}

void LightStates::share() {
  for (const auto& state : states_) {
    const std::size_t bytes = memory_ / states_.size() / (keeps_changes_ ? 2 : 1);
    state->grid.limit(bytes / SurfaceGrid::kBytesPerVertex);
    state->bounces.limit(BounceGrid::cellsBeside(bytes));
  }
}

}  // namespace saccade
