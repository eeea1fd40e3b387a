// Colours a plane of signed values: blue below zero, white at zero, red above.
#pragma once

#include <vector>

#include "eval/pictures/picture_grid.h"

namespace saccade::eval {

// `scale` > 0 is full red, -scale full blue.
Rgb8 divergingColor(float v, float scale);

// `scale` > 0 as above.
GridPicture signedPicture(const ImageF& plane, float scale, const std::string& caption);

// A scale at which few pixels saturate: the 97th percentile of |v|.
float colorScale(const ImageF& plane);

// The key of pictures of dI, dL or events.
inline const ColorKey kChangeKey{"darker (OFF)", "no change", "brighter (ON)"};

}  // namespace saccade::eval
