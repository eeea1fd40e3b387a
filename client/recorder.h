// Writes the batches of a stream to files, one per sensor. A truth channel goes to the file of
// sensorOfTruth().
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/recording_file.h"
#include "client/sequence_check.h"
#include "client/subscriber.h"
#include "saccade/v1/control.pb.h"

namespace saccade::client {

// The file of each sensor: `path` itself for one sensor. For several, the sensor's index stands before the
// extension (events-0.csv).
std::vector<std::string> outputFiles(const std::string& path, int sensors);

class Recorder {
 public:
  // Starts a RecordingFile for each of outputFiles(); `path` may be kStandardOutput. `server` made the
  // stream.
  Recorder(const std::string& path, const WriterInfo& format, const v1::StreamOpened& stream,
           const v1::ServerDescription& server = {});

  // Throws StreamFault if the stream has no such sensor or truth channel, and as RecordingFile does.
  void add(const Batch& batch);
  bool complete() const;  // every sensor and truth channel has ended
  // Gives the files their names. Call it when complete() is true. Throws std::system_error at the first file
  // that cannot be finished: that file and the later ones stay FILE.partial. `lost_events`: by the stream.
  void commit(std::uint64_t lost_events = 0);

  std::uint64_t events() const;
  const Withheld& withheld() const { return withheld_; }  // by all sensors
  std::int64_t time_ns() const;                           // stream time up to which all sensors are complete
  std::int64_t duration_ns() const;                       // from the first packet to time_ns()
  std::vector<std::string> files() const;                 // their present names
  std::vector<v1::RecordedTruth> truth() const;           // of all files
  std::string truthPlace() const;                         // of all files that have truth, with blanks between
  const v1::Recording& about(int sensor) const { return outputs_.at(sensor).file->about(); }

 private:
  struct Output {
    std::unique_ptr<RecordingFile> file;
    bool ended = false;
  };
  struct Truth {
    int sensor;   // that has it in its file
    int channel;  // of that file
    bool ended = false;
  };
  void addTruth(Truth& truth, const Batch& batch);

  std::vector<Output> outputs_;
  std::vector<Truth> truth_;  // by truth channel
  std::optional<std::int64_t> begin_ns_;
  Withheld withheld_;
};

}  // namespace saccade::client
