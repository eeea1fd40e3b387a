#include "wire/packet.h"

#include <zlib.h>

#include <utility>

#include "wire/codec_table.h"
#include "wire/columns.h"

namespace saccade {
namespace {

std::string checkEvents(const v1::PacketHeader& header) {
  if (header.layout() != v1::LAYOUT_COLUMNS)
    return "layout " + std::to_string(header.layout()) + " is unknown";
  if (!findCodec(header.codec())) return "codec " + std::to_string(header.codec()) + " is unknown";
  if (header.count() > kMaxPacketEvents) return "count is above " + std::to_string(kMaxPacketEvents);
  if (header.dt_unit_ns() == 0) return "dt_unit_ns is 0";
  return {};
}

std::string checkKind(const v1::PacketHeader& header, std::size_t payload_bytes) {
  switch (header.kind()) {
    case v1::KIND_EVENTS:
      return checkEvents(header);
    case v1::KIND_HEARTBEAT:
    case v1::KIND_END:
      return header.count() == 0 && payload_bytes == 0 ? "" : "a packet of its kind carries no events";
    case v1::KIND_ERROR:
      return {};
    default:
      return "kind " + std::to_string(header.kind()) + " is unknown";
  }
}

}  // namespace

std::uint32_t crc32Of(std::string_view bytes) {
  return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

Packet sealPacket(v1::PacketHeader header, std::string payload) {
  header.set_crc32(crc32Of(payload));
  return {std::move(header), std::make_shared<const std::string>(std::move(payload))};
}

Packet makeErrorPacket(const std::string& stream_id, const std::string& message) {
  v1::PacketHeader header;
  header.set_stream_id(stream_id);
  header.set_kind(v1::KIND_ERROR);
  return sealPacket(std::move(header), message);
}

std::string checkPacket(const v1::PacketHeader& header, std::string_view payload) {
  if (std::string fault = checkKind(header, payload.size()); !fault.empty()) return fault;
  if (header.crc32() != crc32Of(payload)) return "crc32 does not match the payload";
  return {};
}

std::string decodePacket(const v1::PacketHeader& header, std::string payload, Events& out) {
  out.clear();
  if (std::string fault = checkPacket(header, payload); !fault.empty()) return fault;
  if (header.kind() != v1::KIND_EVENTS) return {};
  const auto raw =
      findCodec(header.codec())->decode(std::move(payload), header.count() * kColumnsBytesPerEvent);
  if (!raw) return "a payload whose size is not 9 bytes an event";
  return decodeColumns(header, *raw, out);
}

}  // namespace saccade
