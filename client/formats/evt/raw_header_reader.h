// The text at the front of a RAW file of Prophesee.
#pragma once

#include <istream>
#include <string>

#include "client/formats/common/reader.h"

namespace saccade::client {

struct RawHeader {
  std::string encoding;  // "EVT3", "EVT2", "EVT21", ...
  ImageSize size;
};

// Leaves `file` at the first byte after the header. Throws FileFault if the header does not name one
// encoding, or if a size in it is none. `path` for errors.
RawHeader readRawHeader(std::istream& file, const std::string& path);

}  // namespace saccade::client
