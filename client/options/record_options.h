// The options of `saccade record`, and what they ask for.
#pragma once

#include <CLI/CLI.hpp>

#include "client/options/imu_options.h"
#include "client/options/record_job.h"
#include "client/options/recording_options.h"
#include "client/options/request_options.h"

namespace saccade::client {

struct RecordOptions {
  RequestOptions request;
  RecordingOptions recording;
  ImuOptions imu;
  bool write_calibration = false, write_poses = false, keep_times = false;
};

void addRecordOptions(CLI::App& command, RecordOptions& options);

// Throws std::invalid_argument with the option at fault, also where a file cannot be written.
RecordJob makeRecordJob(const RecordOptions& options);

}  // namespace saccade::client
