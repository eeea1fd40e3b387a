// The light that is kept while emitters have one set of strengths. A lamp that flickers comes back to
// strengths that it had, and so to known light.
#pragma once

#include <memory>

#include "cache/grid/bounce_grid.h"
#include "cache/grid/surface_grid.h"

namespace saccade {

struct LightState {
  std::uint64_t strengths;  // Frame::light
  SurfaceGrid grid;
  SurfaceGrid changes;  // of light, at the vertices of `grid`, where bodies move
  BounceGrid bounces;
  std::uint32_t frames = 0;      // that have had it
  std::uint32_t last_frame = 0;  // of them
};

class LightStates {
 public:
  // `memory`: bytes of all grids together.
  LightStates(const GridParams& params, std::size_t memory) : params_(params), memory_(memory) {}

  // Makes the state of a frame the current one. If it is new, and there are as many as are kept, it takes the
  // place of the one that was used least recently.
  void enter(std::uint64_t strengths, std::uint32_t frame);

  // Makes room for LightState::changes, which take as much as the grids.
  void keepChanges();

  // Whether a frame with these strengths does not change the state.
  bool isAt(std::uint64_t strengths) const { return !current_ || current_->strengths == strengths; }

  LightState& current() { return *current_; }
  const LightState& current() const { return *current_; }
  // That of the frame before; of the first frame, the current one.
  LightState& previous() { return *previous_; }
  bool changed() const { return current_ != previous_; }
  bool isNew() const { return current_->frames == 1; }

 private:
  static constexpr std::size_t kMost = 8;

  LightState& find(std::uint64_t strengths);
  void share();  // the memory, among all

  GridParams params_;
  std::size_t memory_;
  bool keeps_changes_ = false;
  std::vector<std::unique_ptr<LightState>> states_;
  LightState *current_ = nullptr, *previous_ = nullptr;
};

}  // namespace saccade
