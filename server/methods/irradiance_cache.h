// Caches irradiance on surfaces, for static lighting. The change of a pixel is the difference of two
// look-ups, at its points in both frames, in one state of the cache. README.md is the section of a paper on
// it.
#pragma once

#include <array>

#include "cache/bake/baked_light.h"
#include "cache/grid/light_states.h"
#include "filter/atrous.h"
#include "filter/filter_planes.h"
#include "methods/coat_change.h"
#include "methods/light_change.h"
#include "methods/method.h"
#include "methods/paired_change.h"
#include "methods/svgf.h"

namespace saccade {

// irradiance_cache.cpp states the range and the source of each parameter.
struct IrradianceCacheParams {
  float cell_px = GridParams{}.cell_px;
  float tau = GridParams{}.blend.tau;
  float noise = GridParams{}.blend.noise;
  float noise_weight = GridParams{}.blend.noise_weight;
  int iterations = 3;
  float sigma_l = 3;
  float sigma_l_diff = 6;
  float target = 0.15f;
  float grid_paths = 1;
  int memory_mib = 256;
  float sigma_n = 128;
  float sigma_z = 1;
};

class IrradianceCache final : public SurfaceMethod {
 public:
  // `baked`: light that is known ahead; may be nullptr. A change of the scene's light ends its use.
  IrradianceCache(const IrradianceCacheParams& params, int width, int height, int spp,
                  std::shared_ptr<const BakedLight> baked = nullptr);
  static MethodInfo info();

  void readBaked(Tile tile, Frame& next) override;
  const BounceGrid* plan(int spp, const SurfaceFrame& next, const PoolHandle& pool,
                         StageTimes& times) override;
  bool needsPairs(const FramePair& frames) const override;
  void start(const Frame& first, const PoolHandle& pool) override;
  void estimate(const FramePair& frames, const PoolHandle& pool, IntensityChange& out,
                StageTimes& times) override;

 private:
  // The grid's estimate for the current or the previous frame. readBaked() has set it where light is baked.
  GridEstimate& estimateOf(const Frame& frame) { return estimates_[frame.index % 2]; }
  // Reads the grid at all other points of both frames, from one state of what is known.
  // Asks for rays wherever the direct light of a point may have changed.
  void wantMovingShadows(SurfaceSamples& on, const PoolHandle& pool, StageTimes& times);
  void read(const FramePair& frames, const PoolHandle& pool, StageTimes& times);
  // Reads, and filters both frames' points into filtered_.
  void filter(const FramePair& frames, const PoolHandle& pool, StageTimes& times);
  void addLightChange(const FramePair& frames, const PoolHandle& pool, StageTimes& times);
  // Replaces the change of pixels whose light cannot be cached.
  void fillUncached(const FramePair& frames, const PoolHandle& pool, IntensityChange& out, StageTimes& times);
  void addCoats(const FramePair& frames, const PoolHandle& pool, IntensityChange& out, StageTimes& times);

  IrradianceCacheParams params_;
  AtrousParams atrous_;
  LightStates light_;
  std::shared_ptr<const BakedLight> baked_;
  Placement at_, at_prev_;
  std::array<GridEstimate, 2> estimates_;
  // With the columns of SurfaceSamples.
  ImageF uncertainty_, uncertainty_prev_;
  ImageF shadow_detail_, shadow_detail_prev_;
  std::unique_ptr<LightChange> change_;  // from the first frame on in which a body moves
  std::vector<char> light_moved_;        // by point of the last frame, where the scene has bodies
  std::unique_ptr<CoatChange> coats_;    // from the first frame on that shows one
  FilterPlanes filtered_, scratch_;
  ImageF i_prev_;               // D[i_{t-1}]
  std::uint32_t frames_ = 0;    // planned so far
  std::uint32_t catch_up_ = 0;  // frames in which svgf_ still follows the last change of light
  // SVGF's estimate, for what the grid does not hold; from the first frame on that needs it.
  std::unique_ptr<Svgf> svgf_;
  std::unique_ptr<IntensityChange> uncached_;
  std::unique_ptr<PairedChange> paired_;  // the change of those that have pairs; likewise
};

}  // namespace saccade
