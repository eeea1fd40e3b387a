// A file of events, and FILE.json beside it. It is called FILE.partial until it is complete. Formats with
// WriterInfo::makeJoint hold several sensors.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "client/recording/recorded_sensor.h"

namespace saccade::client {

// The base of the names of a sensor's JSON and folder of truth. It is the file `path`, and for further
// sensors in the same file "PATH.sensor1", "PATH.sensor2".
std::string nameOfSensor(const std::string& path, std::size_t sensor);

// The name of the file `path` until it is complete.
std::string partialOf(const std::string& path);

class RecordingFile {
 public:
  // Starts FILE.partial, or standard output, which gets no JSON. `sensors`: at least one, and only one where
  // the format has no makeJoint. Throws as WriterInfo::make() does.
  RecordingFile(const std::string& path, const WriterInfo& format, std::vector<v1::Recording> sensors);

  // Without commit() the file stays FILE.partial, and can be read too.
  RecordedSensor& sensor(std::size_t index) { return *sensors_.at(index); }

  void close();  // closes all sensors; throws std::system_error
  // After a fault: ends all sensors as well as can be, and returns how many events readers find.
  std::uint64_t salvage();
  // After close(): gives the file its name. Throws std::system_error; the file then stays FILE.partial.
  void commit();
  const std::string& name() const { return name_; }  // the present one

 private:
  const std::string path_;
  std::string name_;
  std::vector<std::unique_ptr<RecordedSensor>> sensors_;
};

}  // namespace saccade::client
