// Weighted local regression of first order: denoises the brightness of a pixel by the features around it.
// Moon et al. 2014, "Adaptive rendering based on weighted local regression"; with the weights of Tsuji et al.
// 2023, "Event-based camera simulation using Monte Carlo path tracing with adaptive denoising".
//
// takes    brightness and features of the pixels of a window
// returns  the a and b of   min sum_j w_j (Y_j - a - b (x_j - x_c))^2,
//          w_j = prod_k max(3/4 (1 - t_k^2), 1e-8),   t = (x_j - x_c) / range of the window, for each feature
#pragma once

#include <array>

#include "frame/frame.h"

namespace saccade {

// Albedo, normal, and place: pixel times depth on both axes, and depth. Their scales do not matter. The
// albedo of what emits E has E / (E + 1) more [Falcor].
inline constexpr std::size_t kRegressionFeatures = 7;
using RegressionFeatures = std::array<float, kRegressionFeatures>;

// The place of a point that a frame shows at (x, y), which may lie between pixels, at a depth.
std::array<float, 3> placeAt(const GBuffer& g, float x, float y, float z);
RegressionFeatures featuresAt(const GBuffer& g, int x, int y);

struct LocalModel {
  float a = 0;  // brightness at the centre
  // Its change per unit of each feature; 0 where the window shows one value.
  RegressionFeatures b{};
  // The range of each feature in the window. Where there is one value: 1, or the depth for a place.
  RegressionFeatures range{};
};

// Of the pixels within `radius` on both axes, inside the picture.
LocalModel fitLocally(const GBuffer& g, const ImageF& brightness, int x, int y, int radius);

}  // namespace saccade
