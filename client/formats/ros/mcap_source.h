// Reads an MCAP file. Source: mcap.dev/spec.
#pragma once

#include <map>

#include "client/formats/common/byte_reader.h"
#include "client/formats/ros/mcap_record.h"
#include "client/formats/ros/ros_source.h"
#include "client/formats/ros/topic_list.h"

namespace saccade::client {

class McapSource final : public RosSource {
 public:
  explicit McapSource(const std::string& path);

  const std::vector<RosTopic>& topics() const override { return topics_.all(); }
  std::optional<Message> next() override;

 private:
  struct Record {
    McapOp op;
    std::uint64_t content, size;  // its place and length, bytes
  };
  void readFooter();
  void findTopics();
  std::optional<Record> nextRecord();
  std::optional<Message> nextMessage();
  bool nextChunk();
  void expandChunk(std::string_view content);
  void describe(McapOp op, std::string_view content);

  std::map<std::uint16_t, std::string> schemas_;  // names of types
  TopicList topics_;
  bool finished_ = false;      // the file ends as it should
  std::uint64_t summary_ = 0;  // its place, byte; 0: none
  std::string chunk_;          // records that are expanded
  std::size_t next_ = 0;       // byte of the next of them
};

}  // namespace saccade::client
