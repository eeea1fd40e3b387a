// The reply about a stream that has been opened, and the request that is kept of it.
#pragma once

#include "app/request/resolve.h"
#include "app/streams/stream.h"

namespace saccade {

v1::StreamOpened describeOpened(ResolvedStream resolved, const Stream& stream, std::uint64_t epoch,
                                int channels);

// A copy of a resolved request without a path that may be long. `request` is the same afterwards.
v1::OpenStream withoutLongPath(v1::OpenStream& request);

}  // namespace saccade
