// The further state of paths over surfaces that are not all diffuse, packed into LivePaths::state.
#pragma once

#include <cstdint>

namespace saccade {

// How the stages shade a surface.
enum class ShadedAs : std::uint32_t {
  kOther,    // one by one
  kDiffuse,  // in lanes: diffuse and opaque
  kPlastic,  // in lanes: rough plastic with GGX microfacets, opaque
};

struct PathState {
  int bounces;      // so far
  bool in_view;     // all surfaces before were mirrors, panes or masks that show the pixel this one
  bool delta;       // samples of the lights cannot find light in the last direction that was not straight on
  bool from_start;  // that direction was chosen at the first vertex
  bool delta_last;  // the last direction was of a delta lobe
  ShadedAs surface;

  static PathState unpack(std::uint32_t bits) {
    return {static_cast<int>(bits >> 8), (bits & kInView) != 0,    (bits & kDelta) != 0,
            (bits & kFromStart) != 0,    (bits & kDeltaLast) != 0, static_cast<ShadedAs>(bits & kSurface)};
  }
  std::uint32_t pack() const {
    return static_cast<std::uint32_t>(bounces) << 8 | (in_view ? kInView : 0) | (delta ? kDelta : 0) |
           (from_start ? kFromStart : 0) | (delta_last ? kDeltaLast : 0) |
           static_cast<std::uint32_t>(surface);
  }

  static constexpr std::uint32_t kSurface = 3, kInView = 4, kDelta = 8, kFromStart = 16, kDeltaLast = 32;
  static constexpr std::uint32_t kOneBounce = 1 << 8;
};

}  // namespace saccade
