// Memory that what a client sends takes, about: MiB.
#pragma once

#include <cstddef>

#include "saccade/v1/control.pb.h"

namespace saccade {

// An open_stream of so many bytes, while it is under way.
double openingMemory(std::size_t bytes);

// The path of a stream, as long as it lives, and the text that tells its feed apart.
double pathMemory(const v1::Trajectory& path);

}  // namespace saccade
