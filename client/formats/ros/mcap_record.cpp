#include "client/formats/ros/mcap_record.h"

#include <zlib.h>

namespace saccade::client {

void appendRecord(std::string& bytes, McapOp op, std::initializer_list<std::string_view> parts) {
  std::uint64_t size = 0;
  for (const std::string_view part : parts) size += part.size();
  appendBytes<std::uint8_t>(bytes, static_cast<std::uint8_t>(op));
  appendBytes<std::uint64_t>(bytes, size);
  for (const std::string_view part : parts) bytes += part;
}

std::string mcapRecord(McapOp op, const McapFields& fields) {
  std::string bytes;
  appendRecord(bytes, op, {fields.bytes()});
  return bytes;
}

std::uint32_t mcapCrc(std::string_view bytes) {
  return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

}  // namespace saccade::client
