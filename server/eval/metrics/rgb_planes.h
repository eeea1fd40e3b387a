// A colour picture.
#pragma once

#include <array>

#include "frame/image.h"

namespace saccade::eval {

using RgbPlanes = std::array<ImageF, 3>;  // linear, of one size

}  // namespace saccade::eval
