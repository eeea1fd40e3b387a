// What is said, and kept, of a stream that has been opened.
#pragma once

#include "app/request/resolve.h"
#include "app/streams/stream_registry.h"

namespace saccade {

v1::StreamOpened describeOpened(ResolvedStream resolved, const Stream& stream, std::uint64_t epoch,
                                int channels);

// What is kept of a resolved request while its stream lives: all but a path that may be long. `request` is
// left as it was.
v1::OpenStream withoutLongPath(v1::OpenStream& request);

}  // namespace saccade
