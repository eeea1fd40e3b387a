// Opens a stream and writes its events to files, with all that is printed meanwhile.
#pragma once

#include <vector>

#include "client/options/record_job.h"
#include "client/options/server_options.h"
#include "saccade/v1/recording.pb.h"

namespace saccade::client {

// Returns what was recorded, by sensor. Throws as ControlClient and Subscription do; std::invalid_argument
// names an option at fault.
std::vector<v1::Recording> recordStream(const ServerOptions& server, const RecordJob& job);

}  // namespace saccade::client
