// Opens a stream, and says what the server made of the request.
#pragma once

#include <cstdio>
#include <functional>
#include <string>

#include "client/stream_handle.h"

namespace saccade::client {

// Throws as StreamHandle does, and std::invalid_argument with the name of a trajectory file at fault.
// `trajectory`: what the user gave. Where it takes long, shows on stderr what the server does.
StreamHandle openStream(ControlClient& control, const v1::OpenStream& request, const std::string& trajectory);
// The same with `show` for the text.
StreamHandle openStream(ControlClient& control, const v1::OpenStream& request, const std::string& trajectory,
                        const std::function<void(const std::string&)>& show);

double streamSeconds(const v1::StreamOpened& opened);  // 0: endless

// Prints to `out`, and warnings to stderr.
void tellOpening(std::FILE* out, const v1::OpenStream& request, const v1::StreamOpened& opened);

}  // namespace saccade::client
