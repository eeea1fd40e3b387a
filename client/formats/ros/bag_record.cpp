#include "client/formats/ros/bag_record.h"

namespace saccade::client {
namespace {

void appendSized(std::string& bytes, std::string_view data) {
  appendBytes<std::uint32_t>(bytes, data.size());
  bytes += data;
}

}  // namespace

void appendTime(std::string& bytes, const RosTime& time) {
  appendBytes<std::uint32_t>(bytes, time.sec);
  appendBytes<std::uint32_t>(bytes, time.nsec);
}

void appendRecord(std::string& bytes, const BagFields& header, std::string_view data) {
  appendSized(bytes, header.bytes());
  appendSized(bytes, data);
}

namespace {

void appendConnection(std::string& records, std::uint32_t id, const BagTopic& topic) {
  BagFields header(BagOp::kConnection), data;
  header.number("conn", id).text("topic", topic.name);
  data.text("topic", topic.name).text("type", topic.type).text("md5sum", topic.md5sum);
  data.text("message_definition", topic.definition);
  appendRecord(records, header, data.bytes());
}

}  // namespace

std::string connectionRecords(const std::vector<BagTopic>& topics) {
  std::string records;
  for (std::uint32_t id = 0; id < topics.size(); ++id) appendConnection(records, id, topics[id]);
  return records;
}

}  // namespace saccade::client
