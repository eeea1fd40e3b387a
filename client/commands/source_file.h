// A file of events that a command reads, with what FILE.json says of it, or FILE.sensor1.json of sensor 1.
#pragma once

#include <CLI/CLI.hpp>
#include <memory>
#include <optional>
#include <string>

#include "client/formats/common/event_check.h"
#include "client/formats/common/reader.h"
#include "saccade/v1/recording.pb.h"

namespace saccade::client {

// --sensor and --topic.
void addSensorOptions(CLI::App& command, SensorChoice& choice);

class SourceFile {
 public:
  // `choice`: whose events. `size`: --size of the command, for the image where neither the file nor its
  // description tells its size. It is "WIDTHxHEIGHT" or empty; nothing: the command has no such option, and
  // compares with the description. Throws std::invalid_argument if the size is missing or contradicts them,
  // std::runtime_error if there is nothing to compare with, and as openReader(). Says on stderr what of the
  // file is left out; the labels of events are, unless `labels`.
  SourceFile(const std::string& path, const SensorChoice& choice, const std::optional<std::string>& size,
             bool labels);

  // Replaces `events` by the next batch; false at the end. Throws FileFault for events that no sensor of this
  // size sends.
  bool read(Events& events);

  const std::string& path() const { return path_; }
  const std::string& description() const { return description_; }  // the name of that JSON
  const ImageSize& size() const { return size_; }
  bool labels() const { return reader_->labels(); }  // whether its events have some
  const std::optional<v1::Recording>& recording() const { return recording_; }  // if there is that JSON

 private:
  const std::string path_;
  std::unique_ptr<Reader> reader_;
  const std::string description_;
  std::optional<v1::Recording> recording_;
  ImageSize size_;
  EventCheck check_;
};

}  // namespace saccade::client
