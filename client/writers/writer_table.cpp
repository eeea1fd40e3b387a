#include <filesystem>
#include <stdexcept>

#include "client/writers/writer.h"

namespace saccade::client {

const std::vector<const WriterInfo*>& writerTable() {
  static const std::vector<const WriterInfo*> table{&kCsvWriter, &kTxtWriter};
  return table;
}

std::string writerNames() {
  std::string names;
  for (const WriterInfo* writer : writerTable()) {
    names += (names.empty() ? "" : ", ") + std::string(writer->extension) + " (" + writer->description + ")";
  }
  return names;
}

const WriterInfo& writerFor(const std::string& path) {
  if (path == kStandardOutput) return kCsvWriter;
  const std::string extension = std::filesystem::path(path).extension();
  for (const WriterInfo* writer : writerTable()) {
    if (extension == writer->extension) return *writer;
  }
  throw std::invalid_argument("'" + path + "' has no known extension; known are " + writerNames());
}

}  // namespace saccade::client
