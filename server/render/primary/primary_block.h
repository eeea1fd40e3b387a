// The pixels of a block of 4 x 4, and what their rays hit. Plain surfaces, which are diffuse and opaque and
// have no bump map, are found and written in lanes. All others are left to be shaded one by one.
#pragma once

#include <array>

#include "base/lane_vectors.h"
#include "base/pool_handle.h"
#include "frame/frame.h"
#include "render/camera/pixel_context.h"
#include "render/world/ray.h"

namespace saccade {

inline constexpr int kBlockEdge = 4, kBlockPixels = kBlockEdge * kBlockEdge;
static_assert(kBlockPixels == kLaneVectors);

// Surfaces by lane.
struct PlainSurfaces {
  LaneVectors point;
  alignas(64) float offset[kLaneVectors];        // of rays that leave it, see ray_offset.h
  LaneVectors geometric_normal, shading_normal;  // unit, on the side the ray came from
  LaneVectors reflectance;                       // black behind a one-sided material
  LaneVectors emission;                          // towards the camera
  alignas(64) float albedo[kLaneVectors];        // luminance of the reflectance
  alignas(64) float width[kLaneVectors];         // of a pixel there, seen at a right angle, scene units
};

// Lane i is pixel (x0 + i % 4, y0 + i / 4). Lanes that are neither plain nor others lie outside the tile.
struct PrimaryBlock {
  int x(int lane) const { return x0 + lane % kBlockEdge; }
  int y(int lane) const { return y0 + lane / kBlockEdge; }

  int x0, y0;
  LaneSet plain, others;               // lanes
  PlainSurfaces surfaces;              // of plain lanes
  std::array<Ray, kBlockPixels> rays;  // of other lanes, and their hits
  std::array<Hit, kBlockPixels> hits;
  std::array<ShapePoint, kBlockPixels> on;  // of plain lanes, where some body deforms
};

// Traces the rays through the centres of `pixels`, at most 4 x 4. Writes the features of plain pixels to `g`,
// and leaves those of other pixels undefined. With a distorted camera no pixel counts as plain.
void tracePrimaryBlock(const PixelContext& view, Tile pixels, GBuffer& g, PrimaryBlock& out);

// The same of cameras without distortion, with lanes of one instruction set.
void tracePrimaryBlockAvx2(const PixelContext& view, Tile pixels, GBuffer& g, PrimaryBlock& out);
void tracePrimaryBlockAvx512(const PixelContext& view, Tile pixels, GBuffer& g, PrimaryBlock& out);

}  // namespace saccade
