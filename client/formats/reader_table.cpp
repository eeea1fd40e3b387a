#include <filesystem>

#include "client/formats/common/reader.h"

namespace saccade::client {

// Each in the file of its format.
extern const ReaderInfo kRawReader, kAedat4Reader, kDsecReader, kNpzReader, kCsvReader, kTxtReader;

const std::vector<const ReaderInfo*>& readerTable() {
  static const std::vector<const ReaderInfo*> table{&kRawReader, &kAedat4Reader, &kDsecReader,
                                                    &kNpzReader, &kCsvReader,    &kTxtReader};
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

}  // namespace saccade::client
