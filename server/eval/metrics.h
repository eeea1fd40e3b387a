// How far a picture is from the truth (DESIGN: what is measured).
#pragma once

#include "frame/image.h"

namespace saccade {

// sum |x - ref| / sum |ref|; 0 if both are 0 everywhere, infinite if only ref is.
double relativeL1(const ImageF& x, const ImageF& ref);

}  // namespace saccade
