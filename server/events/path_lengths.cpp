#include "events/path_lengths.h"

#include <cmath>

namespace saccade {

void PathLengths::add(const Pieces& pieces) {
  for (int i = 0; i < pieces.count; ++i) sum_.at(pieces.x[i], pieces.y[i]) += std::abs(pieces.dL[i]);
}

void PathLengths::complete(ImageF& dL) const {
  for (int y = 0; y < dL.height(); ++y) {
    const float* sum = sum_.row(y);
    float* __restrict path = dL.row(y);
    for (int x = 0; x < dL.width(); ++x) path[x] = sum[x] + std::abs(path[x]);
  }
}

}  // namespace saccade
