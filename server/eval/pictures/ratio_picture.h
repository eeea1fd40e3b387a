// Shows a picture beside another of the same view, and a map of their ratio.
#pragma once

#include <vector>

#include "eval/metrics/block_ratios.h"
#include "eval/pictures/picture_grid.h"

namespace saccade::eval {

inline constexpr double kFullRatioColor = 0.25;  // full colour in the map: 25 % too dark or too bright

// Picture, reference and the map of the blocks' ratios, each of the size of the reference. The first two are
// sRGB with one exposure: the 90th percentile of the reference is at 0.8. The map is blue where the picture
// is too dark, white where equal, red where too bright, grey where not compared.
std::vector<GridPicture> ratioPictures(const RgbPlanes& picture, const RgbPlanes& reference,
                                       const BlockRatios& ratios);
// The three side by side with their names and a key, as SVG.
std::string drawRatios(const RgbPlanes& picture, const RgbPlanes& reference, const BlockRatios& ratios);

}  // namespace saccade::eval
