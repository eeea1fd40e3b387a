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

struct ColumnOptions;

struct ImageSize {
  std::uint32_t width = 0, height = 0;  // pixels; 0: not known
};

// Whose events of a file to read.
struct SensorChoice {
  std::uint32_t sensor = 0;  // number in the file
  std::string topic = {};    // of a bag or an MCAP file, instead of the number
};

// Every call throws FileFault, or std::system_error with the file's name when the file cannot be read.
class Reader {
 public:
  virtual ~Reader() = default;
  virtual ImageSize size() const = 0;
  virtual std::uint32_t sensor() const { return 0; }         // number in the file of the one that is read
  virtual std::string name() const { return "one stream"; }  // of its events, for messages
  virtual bool labels() const { return false; }  // whether the events have labels: Event::source and artefact
  virtual bool objects() const { return false; }  // whether they have objects: Event::object
  // The kinds of content that read() passes over, such as "frames (FRME)"; empty: none.
  virtual std::string leftOut() const { return ""; }
  // The facts that the file did not tell and that were taken for likely, such as the unit of t; empty: none.
  virtual std::string assumed() const { return ""; }
  // Replaces `events` by the next batch, in the order of the file. A batch is small, whatever the file's
  // size, and may be empty. Returns false at the end, with no events.
  virtual bool read(Events& events) = 0;
};

struct ReaderInfo {
  const char* extension;  // ".csv"
  const char* description;
  std::unique_ptr<Reader> (*make)(const std::string& path);
  // With what the user says of the columns; nullptr: the format tells all of it. Throws std::invalid_argument
  // if this does not fit the file.
  std::unique_ptr<Reader> (*makeBy)(const std::string& path, const ColumnOptions& options) = nullptr;
  // For one of several sensors; nullptr: the format holds one. Throws std::invalid_argument for a sensor or
  // topic that the file does not have.
  std::unique_ptr<Reader> (*makeOf)(const std::string& path, const SensorChoice& choice) = nullptr;
};

// All formats that can be read.
const std::vector<const ReaderInfo*>& readerTable();

std::string readerNames();  // ".csv (what it is), ..." for messages

// The reader for the extension of `path`. Throws std::invalid_argument with the known extensions.
const ReaderInfo& readerFor(const std::string& path);

// Opens the file. `columns`: what the user says of them, or nullptr. Throws as readerFor(),
// ReaderInfo::makeBy() and makeOf(), and std::invalid_argument for a choice or options that its format does
// not offer.
std::unique_ptr<Reader> openReader(const std::string& path, const SensorChoice& choice,
                                   const ColumnOptions* columns = nullptr);

}  // namespace saccade::client
