// Writes the packets of a stream to files: one per sensor, or one for all of them where the format holds
// several. A truth channel goes with the sensor of sensorOfTruth().
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/recording/recording_file.h"
#include "saccade/sequence_check.h"
#include "saccade/v1/control.pb.h"
#include "saccade/wire/packet.h"

namespace saccade::client {

// Where the recording of a sensor goes.
struct RecordingPlace {
  std::string file;  // with the events
  std::string name;  // its JSON is NAME.json, and its folder of truth is NAME.truth
};

// By sensor. The file is `path` itself for one sensor, and for several in a format that holds them. Otherwise
// the sensor's index stands before the extension (events-0.csv).
std::vector<RecordingPlace> recordingPlaces(const std::string& path, const WriterInfo& format, int sensors);

class Recorder {
 public:
  // Starts the files of recordingPlaces(); `path` may be kStandardOutput. `server` made the stream.
  Recorder(const std::string& path, const WriterInfo& format, const v1::StreamOpened& stream,
           const v1::ServerDescription& server = {});

  // Says in the files' JSON that the batches of add() have times of their own, see Recording.time_offset_ns.
  void setTimeOffset(std::int64_t offset_ns);
  // Throws StreamFault if the stream has no such sensor or truth channel, and as RecordingFile does.
  void add(const DecodedPacket& batch);
  bool complete() const;  // every sensor and truth channel has ended
  // Gives the files their names. Call it when complete() is true. Throws std::system_error at the first file
  // that cannot be finished: that file and the later ones stay FILE.partial. `lost_events`: by the stream.
  void commit(std::uint64_t lost_events = 0);
  // After a fault: ends all files as well as can be, and returns how many events readers find in them.
  std::uint64_t salvage();

  std::uint64_t events() const;
  const Withheld& withheld() const { return withheld_; }  // by all sensors
  std::int64_t time_ns() const;                           // stream time up to which all sensors are complete
  std::int64_t duration_ns() const;                       // from the first packet to time_ns()
  std::vector<std::string> files() const;                 // their present names
  std::vector<v1::RecordedTruth> truth() const;           // of all files
  std::string truthPlace() const;                         // of all files that have truth, with blanks between
  std::vector<v1::Recording> descriptions() const;        // by sensor
  const v1::Recording& about(int sensor) const { return outputs_.at(sensor).sensor->about(); }

 private:
  struct Output {
    RecordingFile* file;
    RecordedSensor* sensor;  // of the file
    bool ended = false;
  };
  struct Truth {
    int sensor;   // that has it in its recording
    int channel;  // of that recording
    bool ended = false;
  };
  void addFile(const std::string& path, const WriterInfo& format, std::vector<v1::Recording> sensors);
  void tellTruth(const v1::OpenStream& resolved, const std::vector<RecordingPlace>& places);
  void addTruth(Truth& truth, const DecodedPacket& batch);

  std::vector<std::unique_ptr<RecordingFile>> files_;
  std::vector<Output> outputs_;
  std::vector<Truth> truth_;  // by truth channel
  std::optional<std::int64_t> begin_ns_;
  Withheld withheld_;
};

}  // namespace saccade::client
