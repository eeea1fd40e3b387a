// Channels of an MCAP file. Source: mcap.dev/spec.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace saccade::client {

// A channel with a schema of its own. Both have its index + 1 as number.
struct McapChannel {
  std::string topic;            // "/event_camera/events"
  std::string encoding;         // of messages: "cdr"
  std::string metadata_key;     // one pair of the profile, whose value stays empty
  std::string schema_name;      // "event_camera_msgs/msg/EventPacket"
  std::string schema_encoding;  // "ros2msg"
  std::string schema;
};

// Of a channel by its index, and of its schema.
std::uint16_t mcapNumber(std::size_t channel);

// The records of all schemas, and of all channels.
std::string mcapSchemas(const std::vector<McapChannel>& channels);
std::string mcapChannels(const std::vector<McapChannel>& channels);

}  // namespace saccade::client
