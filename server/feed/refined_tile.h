// Refines the pixels of a tile within an interval.
//
// A pixel's log brightness starts as a line between both ends. Where it can have changed, its value in the
// middle is looked up. Where that is off the line, both halves are split in turn. Beside strong contrast they
// are in any case: detail narrower than a pixel may come and go before the middle. Pieces of one length are
// looked up together, in the order of their pixels: rays that share a pixel are as coherent as neighbours
// [ours].
#pragma once

#include <vector>

#include "feed/brightness_range.h"
#include "feed/feed_config.h"
#include "frame/intensity_change.h"
#include "methods/method.h"
#include "render/tiles/point_sampler.h"

namespace saccade {

// The interval between two frames, cut into pieces of equal length.
struct RefinedInterval {
  static constexpr int kMostLevels = 5, kMostPieces = 1 << kMostLevels;

  int levels;                                 // 2^levels pieces; moment k is at k / 2^levels
  std::span<const Camera> cameras;            // by moment, up to 2^levels
  std::span<const PosedScene* const> scenes;  // by moment, or one where nothing moves
  const FrameMotion* motion;                  // nullptr in a scene without bodies
  const ImageF &L0, &L1;                      // log brightness at both ends
  const SurfaceMethod& light;
  const EndShadows& shadows;
  float bias;           // of log brightness
  float contrast;       // of the range that a change needs
  float sharp;          // of the range where both halves are looked up, wherever the middle is
  float enough;         // distance from the line that needs no further piece
  double most_updates;  // see RefinementSettings
  bool every_ray;       // likewise
};

class RefinedTile {
 public:
  // `levels`: at most those of the interval. `reach`: see TileRanges.
  void refine(const RefinedInterval& interval, Tile tile, int levels, int reach);

  // By time, then by pixel.
  const std::vector<IntensityUpdate>& updates() const { return updates_; }
  std::size_t samples() const { return samples_; }  // look-ups, of known light or not
  std::size_t unsplit() const { return unsplit_; }  // pieces that found no room
  std::size_t rays() const { return rays_; }        // see RefinementCounts

 private:
  std::vector<IntensityUpdate> updates_;
  std::size_t samples_ = 0, unsplit_ = 0, rays_ = 0;
};

}  // namespace saccade
