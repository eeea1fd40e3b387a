// A writer puts the events of one sensor into a file of one format.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "wire/event.h"

namespace saccade::client {

// Every call throws std::system_error, naming the file, when it cannot be written.
class Writer {
 public:
  virtual ~Writer() = default;
  // Batch after batch, in time order. Where it throws, the file holds the batches before, and no part of
  // this.
  virtual void write(const Events& events) = 0;
  virtual void finish() = 0;  // the last call: the file is complete and closed
};

struct WriterInfo {
  const char* extension;  // ".csv"
  const char* description;
  std::unique_ptr<Writer> (*make)(const std::string& path);  // starts the file, whatever the path ends with
};

extern const WriterInfo kCsvWriter, kTxtWriter;

// THE list of file formats.
const std::vector<const WriterInfo*>& writerTable();
std::string writerNames();  // ".csv (what it is), ..." for messages

// By the extension of `path`. Throws std::invalid_argument naming the known ones.
const WriterInfo& writerFor(const std::string& path);

}  // namespace saccade::client
