// The request of a recording, and the files that are written of it.
#pragma once

#include <cstdint>
#include <string>

#include "client/formats/common/writer.h"
#include "saccade/v1/control.pb.h"

namespace saccade::client {

class FrameSource;

struct RecordJob {
  v1::OpenStream request;
  std::string output;  // file, or kStandardOutput
  const WriterInfo* format;
  std::string preview = {};         // PNG file, or none
  bool calibration = false;         // whether the cameras are written beside the output
  bool poses = false;               // whether poses of cameras and objects are, as TumFiles
  bool replaces = false;            // whether existing files of poses are replaced
  std::string trajectory = {};      // what the user gave, for errors
  bool keep_times = false;          // files get the times that the trajectory's text has
  std::int64_t time_offset_ns = 0;  // else this is added to stream time
  double retry_time_s = 60;         // to reach a server that is not up yet or lost
  FrameSource* frames = nullptr;    // of a stream with `pushed`
};

}  // namespace saccade::client
