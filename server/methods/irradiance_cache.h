// Caches irradiance on surfaces, for lamps that are steady. The change of a pixel is the difference of two
// look-ups, at its points in both frames, in one state of the cache. README.md is the section of a paper on
// it.
#pragma once

#include "filter/atrous.h"
#include "filter/filter_planes.h"
#include "methods/irradiance_cache_params.h"
#include "methods/known_light.h"
#include "methods/light_change.h"
#include "methods/method.h"
#include "methods/path_plan.h"
#include "methods/uncached_change.h"

namespace saccade {

class IrradianceCache final : public SurfaceMethod {
 public:
  // `baked`: light that is known ahead; may be nullptr. A change of the scene's light ends its use.
  // `refined`: see MethodSetup.
  IrradianceCache(const IrradianceCacheParams& params, int width, int height, int spp,
                  std::shared_ptr<const BakedLight> baked = nullptr, bool refined = false);
  static MethodInfo info();

  void readBaked(Tile tile, Frame& next) override { known_.readBaked(tile, next); }
  const BounceGrid* plan(int spp, const SurfaceFrame& next, const PoolHandle& pool,
                         StageTimes& times) override;
  bool needsPairs(const FramePair& frames) const override { return uncached_.needsPairs(frames); }
  void start(const Frame& first, const PoolHandle& pool) override;
  void estimate(const FramePair& frames, const PoolHandle& pool, IntensityChange& out,
                StageTimes& times) override;
  void readPoints(std::span<const PointSample> at, std::span<PlaceLight> out) const override {
    known_.readPoints(at, out);
  }

 private:
  PathPlan pathPlan(int spp) const;
  // From what is known to the change of pixels: as it is, or filtered.
  std::chrono::nanoseconds modulateLookUps(const FramePair& frames, const PoolHandle& pool,
                                           IntensityChange& out) const;
  void modulateFiltered(const FramePair& frames, int iterations, const PoolHandle& pool, IntensityChange& out,
                        StageTimes& times);
  // Filters both frames' points into filtered_.
  void filter(const FramePair& frames, int iterations, const PoolHandle& pool, StageTimes& times);
  // Adds the change of light at surfaces to that which their motion makes.
  void addLightChange(const FramePair& frames, const PoolHandle& pool, StageTimes& times);

  IrradianceCacheParams params_;
  const bool refined_;
  AtrousParams atrous_;
  KnownLight known_;
  std::unique_ptr<LightChange> change_;  // from the first frame on in which a body moves
  bool moved_ = false;                   // whether one moved into the last frame
  FilterPlanes filtered_, scratch_;
  ImageF i_prev_;                 // D[i_{t-1}]
  std::vector<char> had_others_;  // see planPaths()
  UncachedChange uncached_;
};

}  // namespace saccade
