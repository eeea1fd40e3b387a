#include "saccade/wire/packet.h"

#include <zlib.h>

#include <optional>
#include <utility>

#include "saccade/wire/codec_table.h"
#include "saccade/wire/columns.h"

namespace saccade {
namespace {

std::string checkCodec(const v1::PacketHeader& header) {
  return findCodec(header.codec()) ? "" : "codec " + std::to_string(header.codec()) + " is unknown";
}

std::string checkCoding(const v1::PacketHeader& header, v1::Layout layout) {
  if (header.layout() != layout) {
    return "layout " + std::to_string(header.layout()) + " instead of " + std::to_string(layout);
  }
  return checkCodec(header);
}

std::string checkEvents(const v1::PacketHeader& header) {
  if (header.count() > kMaxPacketEvents) return "count is above " + std::to_string(kMaxPacketEvents);
  if (header.dt_unit_ns() == 0) return "dt_unit_ns is 0";
  if (hasLabels(header.layout()) || hasObjects(header.layout())) return checkCodec(header);
  return checkCoding(header, v1::LAYOUT_COLUMNS);
}

std::uint64_t pixelsOf(const v1::PacketHeader& header) {
  return std::uint64_t{header.width()} * header.height();
}

std::string checkSnapshot(const v1::PacketHeader& header) {
  const std::uint64_t pixels = pixelsOf(header);
  if (pixels == 0 || pixels > kMaxSnapshotPixels) {
    return std::to_string(pixels) + " pixels: 1 to " + std::to_string(kMaxSnapshotPixels) + " are valid";
  }
  return header.count() == 0 ? checkCoding(header, v1::LAYOUT_PLANES) : "a snapshot carries no events";
}

std::string checkSamples(const v1::PacketHeader& header) {
  std::string fault = checkTruth(header);
  return fault.empty() ? checkCodec(header) : fault;
}

// Bytes of the payload before its compression; nothing for kinds without content.
std::optional<std::uint64_t> contentBytes(const v1::PacketHeader& header) {
  switch (header.kind()) {
    case v1::KIND_EVENTS:
      return header.count() * bytesPerEvent(header.layout());
    case v1::KIND_SNAPSHOT:
      return pixelsOf(header) * kPlanesBytesPerPixel;
    case v1::KIND_TRUTH:
      return truthBytes(header);
    default:
      return std::nullopt;
  }
}

std::string checkKind(const v1::PacketHeader& header, std::size_t payload_bytes) {
  switch (header.kind()) {
    case v1::KIND_EVENTS:
      return checkEvents(header);
    case v1::KIND_SNAPSHOT:
      return checkSnapshot(header);
    case v1::KIND_TRUTH:
      return checkSamples(header);
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
  payload.shrink_to_fit();  // it may wait for long
  return {std::move(header), std::make_shared<const std::string>(std::move(payload))};
}

Packet makeErrorPacket(const std::string& stream_id, const std::string& message, std::uint64_t epoch) {
  v1::PacketHeader header;
  header.set_stream_id(stream_id);
  header.set_epoch(epoch);
  header.set_kind(v1::KIND_ERROR);
  return sealPacket(std::move(header), message);
}

std::string checkPacket(const v1::PacketHeader& header, std::string_view payload) {
  if (std::string fault = checkKind(header, payload.size()); !fault.empty()) return fault;
  if (header.crc32() != crc32Of(payload)) return "crc32 does not match the payload";
  return {};
}

std::string decodePacket(const v1::PacketHeader& header, std::string payload, PacketContent& out) {
  out = {};
  if (std::string fault = checkPacket(header, payload); !fault.empty()) return fault;
  const auto size = contentBytes(header);
  if (!size) return {};
  auto raw = findCodec(header.codec())->decode(std::move(payload), *size);
  if (!raw) return "the payload does not hold " + std::to_string(*size) + " bytes";
  if (header.kind() == v1::KIND_EVENTS) return decodeColumns(header, *raw, out.events);
  if (header.kind() == v1::KIND_TRUTH) return decodeTruth(header, std::move(*raw), out.truth);
  out.pixels = decodePlanes(*raw);
  return {};
}

}  // namespace saccade
