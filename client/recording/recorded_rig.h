// The descriptions of all sensors of a recording.
#pragma once

#include <string>
#include <vector>

#include "saccade/v1/recording.pb.h"

namespace saccade::client {

// That of `file`, a FILE.json, and after it those of other sensors of the same request and interval. They
// stand beside it as FILE.sensor1.json, or as a-1.csv.json of numbered files. Throws as readSidecar().
std::vector<v1::Recording> readRig(const std::string& file);

}  // namespace saccade::client
