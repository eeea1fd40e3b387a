// Puts the batches of a stream into files, one per sensor, which get their names only once complete.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "client/subscriber.h"
#include "client/writers/writer.h"

namespace saccade::client {

class Recorder {
 public:
  // Starts FILE.partial for each sensor; with several, FILE is `path` with the sensor's index before the
  // extension (events-0.csv). Throws as writerFor() and Writer do, also where FILE is a folder.
  Recorder(const std::string& path, int sensors);

  // Throws StreamFault where the batch is of a sensor the stream does not have.
  void add(const Batch& batch);
  bool complete() const;  // every sensor has ended
  void commit();          // call when complete: FILE.partial becomes FILE

  std::uint64_t events() const { return events_; }
  std::uint64_t suppressed() const { return suppressed_; }
  std::int64_t time_ns() const;            // stream time up to which all sensors are known
  std::int64_t duration_ns() const;        // from the first packet up to there
  std::vector<std::string> files() const;  // as they are named now

 private:
  struct Output {
    std::string file, now;  // the name it is to get, and the one it has
    std::unique_ptr<Writer> writer;
    std::int64_t time_ns = 0;
    bool ended = false;
  };
  std::vector<Output> outputs_;
  std::optional<std::int64_t> begin_ns_;
  std::uint64_t events_ = 0, suppressed_ = 0;
};

}  // namespace saccade::client
