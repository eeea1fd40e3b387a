// A signed plane beside its truth, to be looked at.
#pragma once

#include <vector>

#include "eval/pictures/exr.h"

namespace saccade::eval {

// `scale` > 0 and above: red; 0: white; below: blue.
Rgb8 divergingColor(float v, float scale);

// One plane: blue below, white at, red above zero; `scale` > 0 is full colour.
std::vector<Rgb8> signedPicture(const ImageF& plane, float scale);

// A scale at which few pixels saturate: the 97th percentile of |v|.
float colorScale(const ImageF& plane);

// x, ref and x - ref side by side, three times as wide as ref: blue below, white at, red above zero. All
// three in one scale, whose full colour is the 97th percentile of |ref|: a few edges must not take it all.
std::vector<Rgb8> differencePicture(const ImageF& x, const ImageF& ref);

}  // namespace saccade::eval
