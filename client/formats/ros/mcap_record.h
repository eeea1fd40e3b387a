// Records of an MCAP file. Source: mcap.dev/spec.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

#include "client/formats/common/little_endian.h"

namespace saccade::client {

inline constexpr std::string_view kMcapMagic("\x89MCAP0\r\n", 8);  // first and last in a file

enum class McapOp : std::uint8_t {
  kHeader = 0x01,
  kFooter = 0x02,
  kSchema = 0x03,
  kChannel = 0x04,
  kMessage = 0x05,
  kChunk = 0x06,
  kMessageIndex = 0x07,
  kChunkIndex = 0x08,
  kStatistics = 0x0B,
  kSummaryOffset = 0x0E,
  kDataEnd = 0x0F
};

// The fields of a record, one after the other.
class McapFields {
 public:
  template <class T>
  McapFields& number(std::type_identity_t<T> value) {
    appendBytes<T>(bytes_, value);
    return *this;
  }
  // Strings, maps and arrays: their size in bytes, and themselves.
  McapFields& sized(std::string_view value) {
    appendBytes<std::uint32_t>(bytes_, value.size());
    bytes_ += value;
    return *this;
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

// The content of a record is that of its parts.
void appendRecord(std::string& bytes, McapOp op, std::initializer_list<std::string_view> parts);
std::string mcapRecord(McapOp op, const McapFields& fields);

// CRC-32 as in zlib.
std::uint32_t mcapCrc(std::string_view bytes);

}  // namespace saccade::client
