// State shared by all packets of one sensor or truth channel.
#pragma once

#include <cstdint>
#include <string>

#include "saccade/v1/events.pb.h"
#include "saccade/wire/codec_table.h"

namespace saccade {

struct PacketSource {
  std::string stream_id;
  std::uint64_t epoch = 0;
  std::uint32_t sensor = 0;             // PacketHeader.sensor
  std::uint32_t width = 0, height = 0;  // pixels
  const CodecInfo* codec = &kCodecNone;
};

// A header with these fields.
v1::PacketHeader headerOf(const PacketSource& source);

}  // namespace saccade
