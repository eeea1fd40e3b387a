// The options of commands that record a stream: what is written, and where.
#pragma once

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

#include "client/options/event_facts.h"
#include "client/options/output_options.h"
#include "client/options/record_job.h"

namespace saccade::client {

struct RecordingOptions {
  OutputOptions output = {};
  std::string preview = {};  // a PNG file, or none
  std::vector<std::string> truth = {};
  EventFacts facts = {};
};

void addRecordingOptions(CLI::App& command, RecordingOptions& options);

// The job for a request of views and sensors, to which it adds truth and labels. Throws std::invalid_argument
// with the option at fault, also where a file cannot be written.
RecordJob makeJob(const RecordingOptions& options, v1::OpenStream request);

}  // namespace saccade::client
