// Classifies the pixels of a frame, so that errors can be assigned to their causes.
#pragma once

#include <cstdint>

#include "frame/frame.h"

namespace saccade::eval {

// Bits, so that several regions can be asked for at once. Every pixel is in exactly one of the first three.
namespace region {
inline constexpr std::uint32_t kSmooth = 1, kCurved = 2, kChanged = 4;
inline constexpr std::uint32_t kUnchanged = kSmooth | kCurved, kAnywhere = kUnchanged | kChanged;
}  // namespace region

using RegionMap = Image<std::uint32_t>;

// A pixel of the previous frame shows the surface that a pixel p sees now, if
// - its depth is z_in_prev(p), as far as the tangent plane reaches: within kSlopes dz(p) per pixel of
//   distance (the sum of both axes) from where p's point was, and kDepthTolerance of z(p); and
// - the normals are within kSameNormalDeg. Pixels without a hit form a surface of their own.
// kChanged: the pixel nearest to where p's point was lies outside the picture or shows another surface, or
//   the previous frame showed another one at p itself. Texture and light play no part.
// kCurved: of the others, where a normal in the 3x3 neighbourhood is more than kCurvedDeg from that at p:
//   curved surfaces, creases, silhouettes.
// kSmooth: the rest.
RegionMap findRegions(const GBuffer& cur, const GBuffer& prev);

inline constexpr float kSlopes = 2, kDepthTolerance = 0.01f;
inline constexpr float kSameNormalDeg = 25, kCurvedDeg = 1;

// Median of `plane` over the pixels in any of the regions `which`, the mean of the middle two where their
// number is even. It is NaN if there are none, or one is NaN.
double median(const ImageF& plane, const RegionMap& regions, std::uint32_t which);

}  // namespace saccade::eval
