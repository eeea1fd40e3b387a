// The reply about a stream that has been opened, and the request that is kept of it.
#pragma once

#include "app/request/resolved_stream.h"
#include "app/streams/stream.h"

namespace saccade {

v1::StreamOpened describeOpened(ResolvedStream resolved, const Stream& stream, std::uint64_t epoch,
                                int channels);

// Keeps a copy of a resolved request without paths that may be long; one that is steered keeps those of its
// objects. `request` is the same afterwards.
void keepRequest(v1::OpenStream& request, Stream& stream);

// The text of a message, cut. It takes no more memory, however large the message is.
std::string shortText(const google::protobuf::Message& message, std::size_t max_bytes);

}  // namespace saccade
