// The header of a file or connection: 4 bytes with its size, then a FlatBuffer.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "client/formats/aedat4/compression.h"

namespace saccade::client::aedat4 {

inline constexpr std::string_view kMagic = "#!AER-DAT4.0\r\n";  // before the header of a file
inline constexpr std::int64_t kNoTable = -1;

struct IoHeader {
  Compression compression = Compression::kNone;
  std::int64_t table_position = kNoTable;  // of the packet table: bytes from the start of the file
  std::string info_node;                   // see info_node.h
};

// The size in bytes does not depend on `table_position`.
std::string encodeHeader(const IoHeader& header);
// `bytes` begin with the size. Throws std::runtime_error if they are no such header.
IoHeader decodeHeader(std::string_view bytes);

}  // namespace saccade::client::aedat4
