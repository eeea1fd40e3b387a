// The primary hit of a pixel, and the features of that pixel that guide the filter.
#pragma once

#include <span>

#include "frame/frame.h"
#include "render/camera/pixel_context.h"
#include "render/primary/guide.h"

namespace saccade {

struct PrimaryHit {
  Vec3 direction;      // of the ray, 1 along the viewing axis
  PathStart start;     // valid where a surface is hit
  Guide guide;         // its emission has no noise; where nothing is hit, that of the environment
  bool valid = false;  // whether a surface is hit
};

inline constexpr std::size_t kMostPoints = 16;  // at once

// Traces the rays through points (x, y) in pixels, as many as there are hits. Pixel centres are whole
// numbers. Neighbours should follow each other, because packets of rays are traced together.
template <Shading S>
void tracePrimaries(const PixelContext& view, std::span<const Vec2> points, std::span<PrimaryHit> hits);

// The features that a traced ray shows.
template <Shading S>
void shadePrimary(const PixelContext& view, const Ray& ray, const Hit& hit, PrimaryHit& out);

// A surface that a point of a pixel shows.
struct Layer {
  PrimaryHit hit;
  float share;        // of the point
  std::size_t point;  // its number
};
inline constexpr std::size_t kMostLayers = 4;  // of a point

// The layers of points, as tracePrimaries() traces them: masks, which are taken for opaque by their share,
// and what is behind them. Returns how many there are. Where there is no room for more, the last one of a
// point is a mask with all that is behind it. There must be room for one of each point.
template <Shading S>
std::size_t traceLayers(const PixelContext& view, std::span<const Vec2> points, std::span<Layer> layers);

// Writes the features of a hit to pixel (x, y) of `g`. `prev` is the camera of the previous frame.
void writeFeatures(const PrimaryHit& primary, const Camera& camera, const Camera& prev, int x, int y,
                   GBuffer& g);

}  // namespace saccade
