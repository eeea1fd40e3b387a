// Packets: what the data and broadcast sockets carry. A header and a payload, made once and shared by all who
// send them.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "saccade/v1/events.pb.h"
#include "wire/event.h"
#include "wire/planes.h"

namespace saccade {

inline constexpr std::uint32_t kMaxPacketEvents = 32768;
inline constexpr std::uint64_t kMaxSnapshotPixels = 4 << 20;
inline constexpr std::uint32_t kTimeUnitNs = 1000;  // event times and packet bounds are multiples of it

struct Packet {
  v1::PacketHeader header;
  std::shared_ptr<const std::string> payload;  // never null
};

// zlib's crc32.
std::uint32_t crc32Of(std::string_view bytes);

// Fills in what the payload decides: crc32.
Packet sealPacket(v1::PacketHeader header, std::string payload);

// KIND_ERROR: the stream as a whole cannot go on. Takes no seq; `message` is UTF-8, for people.
Packet makeErrorPacket(const std::string& stream_id, const std::string& message, std::uint64_t epoch = 0);

// For receivers; header and payload may hold anything. Returns why the packet must not be used, or an empty
// text: unknown kind, layout or codec, more than kMaxPacketEvents events or kMaxSnapshotPixels, a payload
// that its crc32 does not match or whose size does not fit its kind.
std::string checkPacket(const v1::PacketHeader& header, std::string_view payload);

// What a packet of KIND_EVENTS or KIND_SNAPSHOT carries.
struct PacketContent {
  Events events;
  PixelState pixels;
};

// checkPacket() and then the content, of which what the kind does not carry is empty. Returns what is wrong,
// or an empty text.
std::string decodePacket(const v1::PacketHeader& header, std::string payload, PacketContent& out);

}  // namespace saccade
