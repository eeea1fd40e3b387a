#include "eval/metrics.h"

#include <cmath>
#include <limits>

namespace saccade {

double relativeL1(const ImageF& x, const ImageF& ref) {
  double error = 0, size = 0;
  for (int row = 0; row < ref.height(); ++row) {
    for (int column = 0; column < ref.width(); ++column) {
      error += std::abs(static_cast<double>(x.at(column, row)) - ref.at(column, row));
      size += std::abs(static_cast<double>(ref.at(column, row)));
    }
  }
  if (size == 0) return error == 0 ? 0 : std::numeric_limits<double>::infinity();
  return error / size;
}

}  // namespace saccade
