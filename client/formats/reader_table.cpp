#include <filesystem>

#include "client/formats/common/column_names.h"
#include "client/formats/common/reader.h"

namespace saccade::client {

// Each in the file of its format.
extern const ReaderInfo kRawReader, kAedat4Reader, kDsecReader, kHdf5Reader, kNpzReader, kBagReader,
    kMcapReader, kCsvReader, kTxtReader;

const std::vector<const ReaderInfo*>& readerTable() {
  static const std::vector<const ReaderInfo*> table{&kRawReader,  &kAedat4Reader, &kDsecReader,
                                                    &kHdf5Reader, &kNpzReader,    &kBagReader,
                                                    &kMcapReader, &kCsvReader,    &kTxtReader};
  return table;
}

std::string readerNames() {
  std::string names;
  for (const ReaderInfo* reader : readerTable()) {
    names += (names.empty() ? "" : ", ") + std::string(reader->extension) + " (" + reader->description + ")";
  }
  return names;
}

const ReaderInfo& readerFor(const std::string& path) {
  const std::string extension = std::filesystem::path(path).extension();
  for (const ReaderInfo* reader : readerTable()) {
    if (extension == reader->extension) return *reader;
  }
  throw std::invalid_argument("'" + path + "' has no extension that can be read; known are " + readerNames());
}

namespace {

std::unique_ptr<Reader> openSensor(const ReaderInfo& format, const std::string& path,
                                   const SensorChoice& choice) {
  if (!choice.topic.empty() && choice.sensor != 0)
    throw std::invalid_argument("--topic: give a topic or --sensor, not both");
  if (format.makeOf) return format.makeOf(path, choice);
  if (!choice.topic.empty())
    throw std::invalid_argument("--topic: '" + choice.topic + "': '" + path + "' has no topics");
  throw std::invalid_argument("--sensor: '" + path + "' has no sensor " + std::to_string(choice.sensor) +
                              "; a file of " + format.extension + " has one, number 0");
}

}  // namespace

std::unique_ptr<Reader> openReader(const std::string& path, const SensorChoice& choice,
                                   const ColumnOptions* columns) {
  const ReaderInfo& format = readerFor(path);
  const char* told = !columns                    ? nullptr
                     : !columns->columns.empty() ? "--columns"
                     : columns->unit             ? "--unit"
                                                 : nullptr;
  if (!choice.topic.empty() || choice.sensor != 0) {
    if (told) throw std::invalid_argument(std::string(told) + ": not together with --sensor or --topic");
    return openSensor(format, path, choice);
  }
  if (format.makeBy && columns) return format.makeBy(path, *columns);
  if (told)
    throw std::invalid_argument(std::string(told) + ": the format of '" + path + "' (" + format.extension +
                                ") tells it itself");
  return format.make(path);
}

}  // namespace saccade::client
