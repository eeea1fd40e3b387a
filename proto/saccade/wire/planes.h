// LAYOUT_PLANES, 8 bytes a pixel: f32 log brightness[n] | f32 reference level[n], little-endian, row by row
// from the top.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace saccade {

inline constexpr std::size_t kPlanesBytesPerPixel = 8;

// The pixels of a sensor between two intervals. Natural log units: L = log(I_eps + I); the next ON event
// comes where L reaches reference + C+, the next OFF event at reference - C-. The reference of a model
// without memory is L itself.
struct PixelState {
  std::vector<float> brightness, reference;
  bool operator==(const PixelState&) const = default;
};

std::string encodePlanes(const PixelState& pixels);
// `payload` holds a whole number of pixels.
PixelState decodePlanes(std::string_view payload);

}  // namespace saccade
