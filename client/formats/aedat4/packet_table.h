// The table at the end of a file, which says where each packet is.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "client/formats/aedat4/packets.h"

namespace saccade::client::aedat4 {

class PacketTable {
 public:
  // Readers that verify FlatBuffers take a million of tables unless they say otherwise. A file with more
  // packets has no table: DV then finds the packets itself.
  static constexpr std::size_t kMostPackets = 999'999;

  struct Entry {
    std::int64_t offset;  // of the first byte after the packet's header, from the start of the file
    PacketHeader packet;
    std::int64_t events;
    std::int64_t first_us, last_us;  // their times
  };
  void add(const Entry& entry);
  bool whole() const { return whole_; }  // whether it has all packets
  std::string encode() const;            // a FlatBuffer after its size, not compressed

 private:
  std::vector<Entry> entries_;
  bool whole_ = true;
};

}  // namespace saccade::client::aedat4
