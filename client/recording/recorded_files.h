// All files of a recording: those of the recorder, and the poses as text.
#pragma once

#include <cstdint>
#include <optional>

#include "client/recording/recorder.h"
#include "client/recording/tum_files.h"

namespace saccade::client {

struct RecordedFiles {
  Recorder recorder;
  std::optional<TumFiles> poses = {};
  std::int64_t time_offset_ns = 0;  // added to the times of all that is written

  void take(const DecodedPacket& batch);
  // Call it when the recorder is complete. Throws as Recorder::commit().
  void commit(std::uint64_t lost_events = 0);
  std::int64_t streamTime() const { return recorder.time_ns() - time_offset_ns; }  // of the recorder
};

}  // namespace saccade::client
