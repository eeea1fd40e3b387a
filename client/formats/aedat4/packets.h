// Packets of events: 8 bytes with stream and size, then the compressed FlatBuffer.
#pragma once

#include <flatbuffers/flatbuffer_builder.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "client/formats/aedat4/compression.h"
#include "saccade/wire/event.h"

namespace saccade::client::aedat4 {

struct PacketHeader {  // as in the file, little-endian
  std::int32_t stream_id;
  std::int32_t size;  // bytes that follow
};

class PacketEncoder {
 public:
  explicit PacketEncoder(Compression compression) : compressor_(compression) {}

  // Appends the packet of `events`, at least one, with `offset_us` added to their times. Returns its header.
  PacketHeader append(std::string& to, std::span<const Event> events, std::int64_t offset_us = 0);

 private:
  Compressor compressor_;
  flatbuffers::FlatBufferBuilder builder_;
};

// Appends the events of an expanded packet. Throws std::runtime_error if it is no packet of events, or a time
// does not fit into nanoseconds.
void appendEvents(Events& to, std::string_view packet);

}  // namespace saccade::client::aedat4
