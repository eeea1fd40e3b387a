// A picture beside another of the same view, and where their brightness differs.
#pragma once

#include <vector>

#include "eval/metrics/block_ratios.h"
#include "eval/pictures/exr.h"

namespace saccade::eval {

inline constexpr double kFullRatioColor = 0.25;  // full colour in the map: 25 % too dark or too bright

// Picture, reference and the map of the blocks' ratios side by side, three times as wide as the reference.
// Both in one exposure, in which the 90th percentile of the reference is at 0.8, and as sRGB. In the map blue
// is too dark, white equal, red too bright; what is not compared is grey.
std::vector<Rgb8> ratioPicture(const RgbPlanes& picture, const RgbPlanes& reference,
                               const BlockRatios& ratios);

}  // namespace saccade::eval
