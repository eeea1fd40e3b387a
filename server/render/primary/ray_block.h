// Up to sixteen primary rays of any pixels and any times, and the surfaces that they hit: as a PrimaryBlock,
// but without features.
#pragma once

#include "render/primary/primary_block.h"

namespace saccade {

struct RayBlock {
  int count = 0;                            // of rays, in the first lanes
  std::array<Ray, kBlockPixels> rays;       // their directions have length 1 along the viewing axis
  LaneSet plain, others;                    // lanes
  PlainSurfaces surfaces;                   // of plain lanes
  std::array<ShapePoint, kBlockPixels> on;  // of plain lanes
  std::array<Hit, kBlockPixels> hits;       // of other lanes
};

// Traces the rays of a block. `lens`: any of the rays' cameras, which share one lens. Where that is distorted
// no lane counts as plain.
void traceRayBlock(const PosedScene& scene, const Camera& lens, RayBlock& block);

// The same of cameras without distortion, with lanes of one instruction set. `pixel`: Camera::pixel.
void traceRayBlockAvx2(const PosedScene& scene, float pixel, RayBlock& block);
void traceRayBlockAvx512(const PosedScene& scene, float pixel, RayBlock& block);

}  // namespace saccade
