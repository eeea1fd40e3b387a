// What a bake knows of the two frames of a pair. It is read once for each frame: it never changes.
#pragma once

#include <memory>

#include "cache/baked_light.h"

namespace saccade {

class BakedFrames {
 public:
  using Time = SurfaceGrid::Time;

  BakedFrames(std::shared_ptr<const BakedLight> light, int width, int height);

  // Reads at the points of the next frame; the one that was the current frame is the previous one now.
  Time look(const SurfaceSamples& on, const GBuffer& g, const PoolHandle& pool);
  // 1 where the light of the current frame is known.
  const Image<std::uint32_t>& known() const { return now_.known; }
  // Writes what is known of the current and of the previous frame over other estimates.
  Time overwrite(const PoolHandle& pool, GridEstimate& now, GridEstimate& before) const;

 private:
  struct View {
    View(int w, int h) : light(w, h), known(w, h) {}
    void overwriteRow(int y, GridEstimate& out) const;
    GridEstimate light;
    Image<std::uint32_t> known;
  };

  std::shared_ptr<const BakedLight> light_;
  View now_, prev_;
};

}  // namespace saccade
