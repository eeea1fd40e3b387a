// --labels and --object-ids, which ask for facts of each event.
#pragma once

#include <CLI/CLI.hpp>

#include "client/options/output_options.h"
#include "saccade/v1/control.pb.h"

namespace saccade::client {

struct EventFacts {
  bool labels = false, object_ids = false;
};

void addEventFacts(CLI::App& command, EventFacts& facts);

void requestEventFacts(const EventFacts& facts, v1::OpenStream& request);  // of all sensors

// Throws std::invalid_argument with the formats that hold them if the request has some and the output cannot
// hold them.
void checkEventFacts(const OutputOptions& options, const v1::OpenStream& request);

}  // namespace saccade::client
