// Reads a bag of ROS 1, version 2.0. Source: wiki.ros.org/Bags/Format/2.0.
#pragma once

#include "client/formats/ros/bag_fields.h"
#include "client/formats/ros/ros_source.h"
#include "client/formats/ros/topic_list.h"

namespace saccade::client {

class BagSource final : public RosSource {
 public:
  explicit BagSource(const std::string& path);

  const std::vector<RosTopic>& topics() const override { return topics_.all(); }
  std::optional<Message> next() override;

 private:
  struct Record {
    std::string header;
    std::uint64_t data;  // its place, byte
    std::uint32_t size;  // of the data, bytes
  };
  void readBagHeader();
  void findTopics();
  std::optional<std::uint32_t> sizeAt(std::uint64_t at, std::uint64_t end);
  std::optional<Record> nextRecord(std::uint64_t end);
  std::optional<Message> nextMessage();
  bool nextChunk();
  void expandChunk(const Record& record, const BagRecordFields& fields);
  void addTopic(const BagRecordFields& fields, std::string_view data);

  TopicList topics_;
  bool finished_ = false;    // the bag was closed, and has an index
  std::uint64_t begin_ = 0;  // byte of the first record after the header
  std::string chunk_;        // records that are expanded
  std::size_t next_ = 0;     // byte of the next of them
};

}  // namespace saccade::client
