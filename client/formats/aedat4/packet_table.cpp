#include "client/formats/aedat4/packet_table.h"

#include "file_data_table_generated.h"

namespace saccade::client::aedat4 {

void PacketTable::add(const Entry& entry) {
  whole_ = entries_.size() < kMostPackets;
  if (whole_) entries_.push_back(entry);
}

std::string PacketTable::encode() const {
  flatbuffers::FlatBufferBuilder builder;
  std::vector<flatbuffers::Offset<fb::FileDataDefinition>> packets;
  for (const Entry& entry : entries_) {
    const fb::PacketHeader header(entry.packet.stream_id, entry.packet.size);
    packets.push_back(fb::CreateFileDataDefinition(builder, entry.offset, &header, entry.events,
                                                   entry.first_us, entry.last_us));
  }
  fb::FinishSizePrefixedFileDataTableBuffer(builder,
                                            fb::CreateFileDataTable(builder, builder.CreateVector(packets)));
  return {reinterpret_cast<const char*>(builder.GetBufferPointer()), builder.GetSize()};
}

}  // namespace saccade::client::aedat4
