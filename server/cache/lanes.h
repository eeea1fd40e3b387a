// Vectors of floats that one vertex or cell keeps.
#pragma once

namespace saccade {

using Quad = float __attribute__((vector_size(16)));
using Octet = float __attribute__((vector_size(32)));

}  // namespace saccade
