// Opens a stream, and says what the server made of the request.
#pragma once

#include <cstdio>
#include <string>

#include "client/stream_handle.h"

namespace saccade::client {

// Throws as StreamHandle does, and std::invalid_argument with the name of a trajectory file at fault.
// `trajectory`: what the user gave.
StreamHandle openStream(ControlClient& control, const v1::OpenStream& request, const std::string& trajectory);

double streamSeconds(const v1::StreamOpened& opened);  // 0: endless

// Prints to `out`, and warnings to stderr.
void tellOpening(std::FILE* out, const v1::OpenStream& request, const v1::StreamOpened& opened);

}  // namespace saccade::client
