// The memory of the packets that a stream may make the server keep.
#pragma once

#include "app/admission/limits.h"
#include "app/request/resolved_stream.h"

namespace saccade {

// MiB: what waits and what was sent, within the limit `queue`, and the large packets beyond it.
double queueMemory(const ResolvedStream& stream, const Limits& limits);

}  // namespace saccade
