// FILE.json, which says what is known of the file of events FILE.
#pragma once

#include <optional>
#include <string>

#include "saccade/v1/recording.pb.h"

namespace saccade::client {

std::string sidecarOf(const std::string& path);  // "events.csv" has "events.csv.json"

// Throws std::system_error with the file's name.
void writeSidecar(const std::string& file, const v1::Recording& recording);

// Throws std::system_error if `file` cannot be read, and FileFault if it is no such JSON.
v1::Recording readSidecar(const std::string& file);

// The recording that stands beside `path`, if there is one.
std::optional<v1::Recording> recordingOf(const std::string& path);

}  // namespace saccade::client
