// A writer puts the events of one sensor into a file of one format.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "saccade/v1/control.pb.h"
#include "wire/event.h"

namespace saccade::client {

// As a path: standard output.
inline constexpr const char* kStandardOutput = "-";

// Every call throws std::system_error with the file's name when the file cannot be written.
class Writer {
 public:
  virtual ~Writer() = default;
  // Adds a batch; batches come in time order. If this throws, the file holds the earlier batches and no part
  // of this one.
  virtual void write(const Events& events) = 0;
  virtual void finish() = 0;  // the last call: the file is complete and closed
};

struct WriterInfo {
  const char* extension;  // ".csv"
  const char* description;
  // Starts a file at `path`, which may have any extension, or at kStandardOutput. `stream` is the server's
  // reply to open_stream: a header can have the size of the view, the epoch and the settings of `sensor`, an
  // index of the resolved sensors.
  std::unique_ptr<Writer> (*make)(const std::string& path, const v1::StreamOpened& stream, int sensor);
};

extern const WriterInfo kCsvWriter, kTxtWriter;

// All file formats.
const std::vector<const WriterInfo*>& writerTable();
std::string writerNames();  // ".csv (what it is), ..." for messages

// The format for the extension of `path`; CSV for kStandardOutput. Throws std::invalid_argument with the
// known extensions.
const WriterInfo& writerFor(const std::string& path);

}  // namespace saccade::client
