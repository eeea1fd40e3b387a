// Checks a server's reply to open_stream, so that the rest of the client can rely on it.
#pragma once

#include "saccade/v1/control.pb.h"

namespace saccade::client {

// Throws StreamFault unless the reply has a stream with the sensors, truth channels and views of `asked`.
// Sizes, frame rate and delivery must be possible ones too.
void checkOpened(const v1::StreamOpened& opened, const v1::OpenStream& asked);

}  // namespace saccade::client
