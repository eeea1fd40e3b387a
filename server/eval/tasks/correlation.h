// How well one picture is told by another, whatever their scales and offsets.
#pragma once

#include "frame/image.h"

namespace saccade::eval {

// Pearson's coefficient over the pixels. Its square is the share of the variance that an affine fit of one to
// the other explains. NaN where one is uniform.
double correlation(const ImageF& a, const ImageF& b);

}  // namespace saccade::eval
