// The pictures of a card.
#pragma once

#include <vector>

#include "client/drawing/rgb_picture.h"
#include "farm/card/sample_picture.h"

namespace saccade::farm {

// Tiles in rows of four, each with number, split and scene above. Below the events of a tile stand its
// distances: white is near, black far. `samples`: at least one.
client::RgbPicture drawGrid(const DataSet& set, const std::vector<SamplePicture>& samples);

}  // namespace saccade::farm
