// Opens a stream, and says what the server made of the request.
#pragma once

#include <cstdio>
#include <functional>
#include <string>

#include "saccade/stream_handle.h"

namespace saccade::client {

struct OpenJob {
  v1::OpenStream request;
  std::string trajectory = {};  // what the user gave, for errors
  double retry_time_s = 60;     // for a server that is not up yet, or restarts
};

// Throws as StreamHandle does, StreamFault after Ctrl-C, and std::invalid_argument with the name of a
// trajectory file at fault. Where it takes long, shows on stderr what the server does.
StreamHandle openStream(ControlClient& control, const OpenJob& job);
// The same with `show` for the text, and `tell` for a line that says that the server is away.
StreamHandle openStream(ControlClient& control, const OpenJob& job,
                        const std::function<void(const std::string&)>& show,
                        const std::function<void(const std::string&)>& tell);

double streamSeconds(const v1::StreamOpened& opened);  // 0: endless

// Prints to `out`, and warnings to stderr.
void tellOpening(std::FILE* out, const v1::OpenStream& request, const v1::StreamOpened& opened);

}  // namespace saccade::client
