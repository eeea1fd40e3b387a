// Packets, which the data and broadcast sockets carry: a header and a payload that all senders share.
#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <string_view>

#include "saccade/v1/events.pb.h"
#include "saccade/wire/event.h"
#include "saccade/wire/planes.h"
#include "saccade/wire/truth_samples.h"

namespace saccade {

inline constexpr std::uint32_t kMaxPacketEvents = 32768;
inline constexpr std::uint64_t kMaxSnapshotPixels = 4 << 20;

struct Packet {
  v1::PacketHeader header;
  std::shared_ptr<const std::string> payload;  // never null
};

// zlib's crc32.
std::uint32_t crc32Of(std::string_view bytes);

// Makes a packet: fills in the payload's crc32.
Packet sealPacket(v1::PacketHeader header, std::string payload);

// A packet of KIND_ERROR: the whole stream cannot go on. It has no seq. `message`: UTF-8, for people.
Packet makeErrorPacket(const std::string& stream_id, const std::string& message, std::uint64_t epoch = 0);

// For receivers; header and payload may hold anything. Returns an empty text, or why the packet must not be
// used:
// - its kind, layout or codec is unknown;
// - it has more than kMaxPacketEvents events, kMaxSnapshotPixels, kMaxPicturePlanes or kMaxPacketRows;
// - its crc32 or size does not fit the payload.
std::string checkPacket(const v1::PacketHeader& header, std::string_view payload);

// The content of a packet of KIND_EVENTS, KIND_SNAPSHOT or KIND_TRUTH.
struct PacketContent {
  Events events;
  PixelState pixels;
  TruthSamples truth;
};

struct DecodedPacket : PacketContent {
  v1::PacketHeader header;
};

// checkPacket(), then decodes the content into `out`; what the kind does not carry stays empty. Returns an
// empty text, or what is wrong.
std::string decodePacket(const v1::PacketHeader& header, std::string payload, PacketContent& out);

}  // namespace saccade
