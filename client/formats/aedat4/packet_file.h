// Finds the packets of a file, one after the other, whether it has a table of them or not.
#pragma once

#include <cstdint>
#include <fstream>
#include <optional>
#include <string>
#include <vector>

#include "client/formats/aedat4/info_node.h"
#include "client/formats/aedat4/io_header.h"

namespace saccade::client::aedat4 {

// Every call throws FileFault with the place in bytes, or std::system_error when the file cannot be read.
class PacketFile {
 public:
  explicit PacketFile(const std::string& path);

  const std::vector<Stream>& streams() const { return streams_; }  // at least one

  struct Packet {
    std::uint64_t start;  // bytes
    const Stream* stream;
    std::uint32_t size;  // bytes after its header
  };
  // Nothing at the end. A file without a table is one that was not finished: a packet that is cut off at its
  // end is not a fault. A packet that is not asked for content() is passed over.
  std::optional<Packet> next();
  // The expanded content of the packet that next() gave.
  const std::string& content(const Packet& packet);

  [[noreturn]] void fail(const Packet& packet, const std::string& what) const;

 private:
  void readHeader();
  const Stream* streamOf(std::int32_t id) const;
  std::string take(std::uint64_t from, std::uint64_t size);
  [[noreturn]] void fail(const std::string& what) const;

  const std::string path_;
  std::ifstream file_;
  const std::uint64_t file_size_;
  IoHeader header_;
  std::vector<Stream> streams_;
  std::uint64_t at_ = 0;  // the next packet
  std::string content_;
};

}  // namespace saccade::client::aedat4
