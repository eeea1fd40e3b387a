// An MCAP file with the messages of one channel. Source: mcap.dev/spec. Messages lie in chunks without
// compression, each followed by its index. The summary at the end of the file tells where the chunks are.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "client/writers/chunked_file.h"

namespace saccade::client {

struct McapChannel {
  std::string profile;          // "ros2"
  std::string topic;            // "/event_camera/events"
  std::string encoding;         // of messages: "cdr"
  std::string metadata_key;     // one pair of the profile, whose value stays empty
  std::string schema_name;      // "event_camera_msgs/msg/EventPacket"
  std::string schema_encoding;  // "ros2msg"
  std::string schema;
};

// The messages of one chunk, or of the file.
struct McapSpan {
  std::uint64_t begin_ns = 0, end_ns = 0;  // of the first and the last message
  std::uint64_t messages = 0;
};

struct McapChunk {
  McapSpan span;
  std::uint64_t position = 0, size = 0;  // of its record in the file, bytes
  std::uint64_t index_size = 0;          // of the record after it
  std::uint64_t content_size = 0;        // of the records within it
};

// Appends the record that stands for the chunk in the summary.
void appendChunkIndex(std::string& records, const McapChunk& chunk);

// Every call throws std::system_error as ChunkedFile does.
class McapFile {
 public:
  McapFile(const std::string& path, const McapChannel& channel);
  // Without finish(), or where it fails, the file gets the summary of the chunks that are in it.
  ~McapFile();
  McapFile(const McapFile&) = delete;
  McapFile& operator=(const McapFile&) = delete;

  // Messages come in the order of time. `events`: how many there are in this one.
  void add(std::uint64_t time_ns, std::string_view message, std::uint64_t events);
  void finish();  // the last call

 private:
  void writeChunk();
  void writeSummary();

  ChunkedFile file_;
  const std::string schema_, channel_;  // their records
  std::string chunk_, entries_;         // of the chunk that is being filled: records, index
  McapSpan span_, whole_;               // of the same, and of the chunks in the file
  std::string chunk_indexes_;           // of the chunks in the file
  std::uint32_t chunk_count_ = 0;       // the same
  std::uint32_t sequence_ = 0;          // of the next message
  std::uint64_t events_ = 0;            // of the chunk that is being filled
  bool finished_ = false;
};

}  // namespace saccade::client
