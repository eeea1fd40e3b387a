// A bag of ROS 1 with the messages of one topic. Source: wiki.ros.org/Bags/Format/2.0. Messages lie in chunks
// without compression, each followed by its index. The file ends with one record for each chunk.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include "client/writers/chunked_file.h"

namespace saccade::client {

struct RosTime {
  std::uint32_t sec, nsec;
};

struct BagTopic {
  std::string name;        // "/dvs/events"
  std::string type;        // "dvs_msgs/EventArray"
  std::string md5sum;      // of the type
  std::string definition;  // of the type, and of the types that it uses
};

// The messages of one chunk.
struct BagChunk {
  std::uint64_t position = 0;  // in the file, bytes
  RosTime begin{}, end{};      // of the first and the last message
  std::uint32_t messages = 0;
};

// Appends the record that stands for the chunk at the end of the file.
void appendChunkInfo(std::string& records, const BagChunk& chunk);

// Every call throws std::system_error as ChunkedFile does.
class BagFile {
 public:
  BagFile(const std::string& path, const BagTopic& topic);

  // Without finish(), or where it fails, the file gets the index of the chunks that are in it.
  ~BagFile();
  BagFile(const BagFile&) = delete;
  BagFile& operator=(const BagFile&) = delete;

  // Messages come in the order of time. `events`: how many there are in this one.
  void add(const RosTime& time, std::string_view message, std::uint64_t events);
  void finish();  // the last call

 private:
  void writeChunk();
  void writeIndex();

  ChunkedFile file_;
  const std::string connection_;   // the record of the topic
  std::string chunk_, entries_;    // of the chunk that is being filled: records, index
  BagChunk about_;                 // of the same
  std::string chunk_infos_;        // of the chunks in the file
  std::uint32_t chunk_count_ = 0;  // the same
  std::uint64_t events_ = 0;       // of the chunk that is being filled
  bool finished_ = false;
};

}  // namespace saccade::client
