#include "client/formats/ros/mcap_channel.h"

#include "client/formats/ros/mcap_record.h"

namespace saccade::client {

std::uint16_t mcapNumber(std::size_t channel) {
  return static_cast<std::uint16_t>(channel + 1);
}

std::string mcapSchemas(const std::vector<McapChannel>& channels) {
  std::string records;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    McapFields fields;
    fields.number<std::uint16_t>(mcapNumber(i)).sized(channels[i].schema_name);
    fields.sized(channels[i].schema_encoding).sized(channels[i].schema);
    records += mcapRecord(McapOp::kSchema, fields);
  }
  return records;
}

std::string mcapChannels(const std::vector<McapChannel>& channels) {
  std::string records;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    McapFields fields, metadata;
    metadata.sized(channels[i].metadata_key).sized("");
    fields.number<std::uint16_t>(mcapNumber(i)).number<std::uint16_t>(mcapNumber(i)).sized(channels[i].topic);
    fields.sized(channels[i].encoding).sized(metadata.bytes());
    records += mcapRecord(McapOp::kChannel, fields);
  }
  return records;
}

}  // namespace saccade::client
