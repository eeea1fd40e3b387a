// A bag of ROS 1. Source: wiki.ros.org/Bags/Format/2.0. Messages lie in chunks without compression, each
// followed by its index. The file ends with one record for each chunk.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "client/formats/common/output_file.h"
#include "client/formats/ros/bag_record.h"

namespace saccade::client {

// The messages of one chunk.
struct BagChunk {
  std::uint64_t position = 0;                // in the file, bytes
  RosTime begin{}, end{};                    // of the earliest and the latest message
  std::vector<std::uint32_t> messages = {};  // how many, by topic
};

// Appends the record that stands for the chunk at the end of the file.
void appendChunkInfo(std::string& records, const BagChunk& chunk);

// Every call throws std::system_error with the file's name when the file cannot be written.
class BagFile {
 public:
  BagFile(const std::string& path, const std::vector<BagTopic>& topics);

  // Without finish(), or where it fails, the file gets the index of the chunks that are in it.
  ~BagFile();
  BagFile(const BagFile&) = delete;
  BagFile& operator=(const BagFile&) = delete;

  // Messages of a topic come in the order of time. `topic`: its index. `events`: how many there are in the
  // message.
  void add(std::size_t topic, const RosTime& time, std::string_view message, std::uint64_t events = 0);
  void finish();  // the last call
  // Events of a topic that are in the chunks of the file.
  std::uint64_t kept(std::size_t topic) const { return kept_[topic]; }

 private:
  void startChunk();
  void writeChunk();
  void writeIndex();

  OutputFile file_;
  const std::string connections_;     // the records of the topics
  std::string chunk_;                 // the records of the chunk that is being filled
  std::vector<std::string> entries_;  // its index, by topic
  BagChunk about_;                    // of the same
  std::string chunk_infos_;           // of the chunks in the file
  std::uint32_t chunk_count_ = 0;     // the same
  std::vector<std::uint64_t> events_,
      kept_;  // by topic: of the chunk that is being filled, and of the others
  bool finished_ = false;
};

}  // namespace saccade::client
