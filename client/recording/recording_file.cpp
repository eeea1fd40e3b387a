#include "client/recording/recording_file.h"

#include <filesystem>
#include <utility>

namespace saccade::client {
namespace {

Writers makeWriters(const std::string& path, const WriterInfo& format,
                    const std::vector<v1::Recording>& sensors) {
  if (sensors.size() > 1) return format.makeJoint(path, sensors);
  Writers writers;
  writers.push_back(format.make(path, sensors.front()));
  return writers;
}

}  // namespace

std::string nameOfSensor(const std::string& path, std::size_t sensor) {
  return sensor == 0 ? path : path + ".sensor" + std::to_string(sensor);
}

std::string partialOf(const std::string& path) {
  return path + ".partial";
}

RecordingFile::RecordingFile(const std::string& path, const WriterInfo& format,
                             std::vector<v1::Recording> sensors)
    : path_(path), name_(path == kStandardOutput ? path : partialOf(path)) {
  Writers writers = makeWriters(name_, format, sensors);
  for (std::size_t i = 0; i < sensors.size(); ++i)
    sensors_.push_back(std::make_unique<RecordedSensor>(nameOfSensor(name_, i), format, std::move(writers[i]),
                                                        std::move(sensors[i])));
}

void RecordingFile::close() {
  for (const auto& sensor : sensors_) sensor->close();
}

std::uint64_t RecordingFile::salvage() {
  for (const auto& sensor : sensors_) sensor->endAnyway();
  std::uint64_t events = 0;
  for (const auto& sensor : sensors_) events += sensor->kept();
  return events;
}

void RecordingFile::commit() {
  if (path_ == kStandardOutput) return;
  for (std::size_t i = 0; i < sensors_.size(); ++i) sensors_[i]->commit(nameOfSensor(path_, i));
  std::filesystem::rename(name_, path_);
  name_ = path_;
}

}  // namespace saccade::client
