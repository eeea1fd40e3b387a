// An OutputFile of a format whose events are on disk in whole chunks.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "client/writers/output_file.h"

namespace saccade::client {

class ChunkedFile : public OutputFile {
 public:
  explicit ChunkedFile(const std::string& path) : OutputFile(path), path_(path) {}

  // As append(). If this throws, the error says how many events the file has.
  void appendChunk(std::string_view bytes, std::uint64_t events);

 private:
  const std::string path_;    // for errors
  std::uint64_t events_ = 0;  // in the chunks of the file
};

}  // namespace saccade::client
