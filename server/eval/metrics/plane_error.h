// Errors of a plane against the truth. NaN in a plane gives NaN.
#pragma once

#include "frame/image.h"

namespace saccade::eval {

// sum |x - ref| / sum |ref|; 0 if both are 0 everywhere, infinite if only ref is. The headline.
double relativeL1(const ImageF& x, const ImageF& ref);

// Mean over the pixels of |x - ref| / (|ref| + kMapeFloor * mean |ref|); 0 and infinite as above.
double mape(const ImageF& x, const ImageF& ref);
inline constexpr double kMapeFloor = 0.01;  // where ref is 0, an error of 1 % of its mean counts as 1

}  // namespace saccade::eval
