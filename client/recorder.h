// Writes the batches of a stream to files, one per sensor. A file gets its name only when it is complete.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/subscriber.h"
#include "client/writers/writer.h"
#include "saccade/v1/control.pb.h"

namespace saccade::client {

// The file of each sensor: `path` itself for one sensor. For several, the sensor's index stands before the
// extension (events-0.csv).
std::vector<std::string> outputFiles(const std::string& path, int sensors);

class Recorder {
 public:
  // Starts FILE.partial for each of outputFiles(); `path` may be kStandardOutput. Throws as writerFor() and
  // Writer do.
  Recorder(const std::string& path, const v1::StreamOpened& stream);

  // Throws StreamFault if the stream has no such sensor.
  void add(const Batch& batch);
  bool complete() const;  // every sensor has ended
  // Renames FILE.partial to FILE. Call it when complete() is true. Throws std::system_error at the first file
  // that cannot be finished: that file and the later ones keep the name FILE.partial.
  void commit();

  std::uint64_t events() const { return events_; }
  std::uint64_t suppressed() const { return suppressed_; }
  std::int64_t time_ns() const;            // stream time up to which all sensors are complete
  std::int64_t duration_ns() const;        // from the first packet to time_ns()
  std::vector<std::string> files() const;  // their present names

 private:
  struct Output {
    std::string file, now;  // the final name and the present one
    std::unique_ptr<Writer> writer;
    std::int64_t time_ns = 0;
    bool ended = false;
  };
  std::vector<Output> outputs_;
  std::optional<std::int64_t> begin_ns_;
  std::uint64_t events_ = 0, suppressed_ = 0;
};

}  // namespace saccade::client
