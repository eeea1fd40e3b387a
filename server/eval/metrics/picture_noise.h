// The noise of a rendered picture, pixel by pixel.
#pragma once

#include "eval/metrics/rgb_planes.h"

namespace saccade::eval {

// The root mean square over the pixels of the difference of luminance, divided by the mean luminance of the
// reference. It holds the noise of both pictures, and what the mean of the picture is off. Pictures of one
// size. 0 for equal pictures; infinite where only the reference is black; NaN where a pixel is no number.
double relativeNoise(const RgbPlanes& picture, const RgbPlanes& reference);

}  // namespace saccade::eval
