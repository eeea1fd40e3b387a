// Turns linear light into 8-bit sRGB.
#pragma once

#include "eval/pictures/picture_grid.h"

namespace saccade::eval {

// Linear 0 to 1; clamps what lies beyond.
unsigned char encodeSrgb(float linear);

// The factor that brings the 90th percentile of a luminance to 0.8. Values that are not finite count as 0.
float exposureOf(const ImageF& luminance);

GridPicture greyPicture(const ImageF& luminance, float exposure);

}  // namespace saccade::eval
