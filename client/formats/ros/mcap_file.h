// An MCAP file. Source: mcap.dev/spec. Messages lie in chunks without compression, each followed by its
// index. The summary at the end of the file tells where the chunks are.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "client/formats/common/output_file.h"
#include "client/formats/ros/mcap_channel.h"

namespace saccade::client {

// The messages of one chunk, or of the file.
struct McapSpan {
  std::uint64_t begin_ns = 0, end_ns = 0;  // of the earliest and the latest message
  std::uint64_t messages = 0;
};

struct McapChunk {
  McapSpan span;
  std::uint64_t position = 0, size = 0;  // of its record in the file, bytes
  // Of the records after it: number of the channel and position in the file, and the size of all.
  std::vector<std::pair<std::uint16_t, std::uint64_t>> indexes = {};
  std::uint64_t index_size = 0;
  std::uint64_t content_size = 0;  // of the records within it
};

// Appends the record that stands for the chunk in the summary.
void appendChunkIndex(std::string& records, const McapChunk& chunk);

// Every call throws std::system_error with the file's name when the file cannot be written.
class McapFile {
 public:
  // `profile`: "ros2".
  McapFile(const std::string& path, const std::string& profile, const std::vector<McapChannel>& channels);
  // Without finish(), or where it fails, the file gets the summary of the chunks that are in it.
  ~McapFile();
  McapFile(const McapFile&) = delete;
  McapFile& operator=(const McapFile&) = delete;

  // `channel`: its index. `events`: how many there are in the message.
  void add(std::size_t channel, std::uint64_t time_ns, std::string_view message, std::uint64_t events = 0);
  void finish();  // the last call
  // Events of a channel that are in the chunks of the file.
  std::uint64_t kept(std::size_t channel) const { return counts_[channel].kept; }

 private:
  void writeChunk();
  void writeSummary();

  struct Channel {
    std::string entries;         // of the index of the chunk that is being filled
    std::uint32_t sequence = 0;  // of the next message
    std::uint64_t messages = 0;  // in the chunks of the file
    std::uint64_t events = 0;    // in the chunk that is being filled
    std::uint64_t kept = 0;      // events in the chunks of the file
  };
  std::string statisticsRecord() const;

  OutputFile file_;
  const std::string schemas_, channels_;  // their records
  std::vector<Channel> counts_;           // by channel
  std::string chunk_;                     // the records of the chunk that is being filled
  McapSpan span_, whole_;                 // of the same, and of the chunks in the file
  std::string chunk_indexes_;             // of the chunks in the file
  std::uint32_t chunk_count_ = 0;         // the same
  bool finished_ = false;
};

}  // namespace saccade::client
