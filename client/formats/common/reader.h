// A reader takes the events of one sensor from a file of one format.
#pragma once

#include <cstdint>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "saccade/wire/event.h"

namespace saccade::client {

// The file is not what its extension says. The text names the file, and the place in it.
class FileFault : public std::runtime_error {
 public:
  FileFault(const std::string& path, const std::string& what) : std::runtime_error(path + ": " + what) {}
};

struct ImageSize {
  std::uint32_t width = 0, height = 0;  // pixels; 0: not known
};

// Every call throws FileFault, or std::system_error with the file's name when the file cannot be read.
class Reader {
 public:
  virtual ~Reader() = default;
  virtual ImageSize size() const = 0;
  virtual bool labels() const { return false; }  // whether the events have labels: Event::source and artefact
  // The kinds of content that read() passes over, such as "frames (FRME)"; empty: none.
  virtual std::string leftOut() const { return ""; }
  // Replaces `events` by the next batch, in the order of the file. A batch is small, whatever the file's
  // size, and may be empty. Returns false at the end, with no events.
  virtual bool read(Events& events) = 0;
};

struct ReaderInfo {
  const char* extension;  // ".csv"
  const char* description;
  std::unique_ptr<Reader> (*make)(const std::string& path);
};

// All formats that can be read.
const std::vector<const ReaderInfo*>& readerTable();

std::string readerNames();  // ".csv (what it is), ..." for messages

// The reader for the extension of `path`. Throws std::invalid_argument with the known extensions.
const ReaderInfo& readerFor(const std::string& path);

}  // namespace saccade::client
