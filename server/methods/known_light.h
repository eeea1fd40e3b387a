// The light at the points of a frame and of the one before it, as the grid and a bake know it.
//
// takes    the points of each frame, and then its samples
// returns  the illumination of both frames' pixels, from one state of the grid, and the doubt in it
#pragma once

#include <array>
#include <memory>
#include <span>
#include <vector>

#include "cache/bake/baked_light.h"
#include "cache/grid/light_states.h"
#include "frame/surface_frame.h"
#include "methods/stage_times.h"

namespace saccade {

class KnownLight {
 public:
  // `memory`: bytes of all grids. `baked`: see IrradianceCache. `refined`: see MethodSetup.
  KnownLight(const GridParams& params, std::size_t memory, std::shared_ptr<const BakedLight> baked, int width,
             int height, bool refined);

  // Reads the bake at a tile of the next frame, and marks points that it knows. Called before enter().
  void readBaked(Tile tile, Frame& next);
  // Finds the points of the next frame in the grid, and asks for the shadow rays that it needs there.
  void enter(const SurfaceFrame& next, const PoolHandle& pool, StageTimes& times);
  // After enter(): see SurfaceGrid::errorOfChange().
  const ImageF& errorOfChange(const SurfaceFrame& next, const PoolHandle& pool, StageTimes& times);
  // Adds the samples of the frame that was entered last, and reads both frames.
  void read(const FramePair& frames, const PoolHandle& pool, StageTimes& times);

  // See SurfaceMethod. The bake's light, and the grid's where the bake knows none.
  void readPoints(std::span<const PointSample> at, std::span<PlaceLight> out) const;

  // Of the current frame or the one before it, after read().
  const GridEstimate& of(const Frame& frame) const { return estimates_[frame.index % 2]; }
  // After enter():
  const ImageF& uncertainty() const { return uncertainty_; }
  const Placement& at() const { return at_; }
  LightState& state() { return states_.current(); }
  void keepChanges() { states_.keepChanges(); }
  bool changed() const { return states_.changed(); }  // the strengths of lamps, since the frame before
  bool isNew() const { return states_.isNew(); }      // whether no frame had these strengths before
  std::uint32_t frames() const { return frames_; }    // entered so far
  bool hasBake() const { return baked_ != nullptr; }

 private:
  GridEstimate& estimateOf(const Frame& frame) { return estimates_[frame.index % 2]; }
  // Asks for rays wherever the grid or the bake cannot tell visibility in one of both frames.
  void wantShadows(SurfaceSamples& on, const PoolHandle& pool, StageTimes& times);
  // Asks for rays wherever the direct light of a point may have changed.
  void wantMovingShadows(SurfaceSamples& on, const PoolHandle& pool, StageTimes& times);
  void readGrid(const FramePair& frames, const PoolHandle& pool, StageTimes& times);
  // Takes the visibility that rays tell into what is baked.
  void readBakedShadows(const FramePair& frames, const PoolHandle& pool, StageTimes& times);

  const bool refined_;
  LightStates states_;
  std::shared_ptr<const BakedLight> baked_;
  Placement at_, at_prev_;
  std::array<GridEstimate, 2> estimates_;
  // With the columns of SurfaceSamples.
  ImageF uncertainty_, uncertainty_prev_;
  ImageF shadow_detail_, shadow_detail_prev_;
  ImageF error_of_change_;         // from the first frame on that asks for it
  bool asks_rays_ = false;         // whether any point of the last frame could
  std::vector<char> light_moved_;  // by point of the last frame, where the scene has bodies
  std::uint32_t frames_ = 0;
};

}  // namespace saccade
