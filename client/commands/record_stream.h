// Opens a stream and writes its events to files, with all that is printed meanwhile.
#pragma once

#include <string>
#include <vector>

#include "client/commands/commands.h"
#include "client/formats/common/writer.h"
#include "client/frames/frame_source.h"
#include "saccade/v1/control.pb.h"
#include "saccade/v1/recording.pb.h"

namespace saccade::client {

struct RecordJob {
  v1::OpenStream request;
  std::string output;  // file, or kStandardOutput
  const WriterInfo* format;
  std::string preview = {};         // PNG file, or none
  bool calibration = false;         // whether the cameras are written beside the output
  bool poses = false;               // whether their poses are, as TumFiles
  std::string trajectory = {};      // what the user gave, for errors
  bool keep_times = false;          // files get the times that the trajectory's text has
  std::int64_t time_offset_ns = 0;  // else this is added to stream time
  double retry_time_s = 60;         // to reach a server that is not up yet or lost
  FrameSource* frames = nullptr;    // of a stream with `pushed`
};

// Returns what was recorded, by sensor. Throws as ControlClient and Subscription do; std::invalid_argument
// names an option at fault.
std::vector<v1::Recording> recordStream(const ServerOptions& server, const RecordJob& job);

}  // namespace saccade::client
