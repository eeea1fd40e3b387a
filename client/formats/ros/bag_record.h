// Records of a bag. Source: wiki.ros.org/Bags/Format/2.0.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "client/formats/common/little_endian.h"

namespace saccade::client {

struct RosTime {
  std::uint32_t sec, nsec;

  friend auto operator<=>(const RosTime&, const RosTime&) = default;
};

struct BagTopic {
  std::string name;        // "/dvs/events"
  std::string type;        // "dvs_msgs/EventArray"
  std::string md5sum;      // of the type
  std::string definition;  // of the type, and of the types that it uses
};

enum class BagOp : std::uint8_t {
  kMessage = 2,
  kBagHeader = 3,
  kIndex = 4,
  kChunk = 5,
  kChunkInfo = 6,
  kConnection = 7
};

void appendTime(std::string& bytes, const RosTime& time);

// The fields name=value of a record's header.
class BagFields {
 public:
  BagFields() = default;
  explicit BagFields(BagOp op) { number<std::uint8_t>("op", static_cast<std::uint8_t>(op)); }

  BagFields& text(std::string_view name, std::string_view value) {
    appendBytes<std::uint32_t>(bytes_, name.size() + 1 + value.size());
    ((bytes_ += name) += '=') += value;
    return *this;
  }
  template <class T>
  BagFields& number(std::string_view name, T value) {
    std::string bytes;
    appendBytes<T>(bytes, value);
    return text(name, bytes);
  }
  BagFields& time(std::string_view name, const RosTime& time) {
    std::string bytes;
    appendTime(bytes, time);
    return text(name, bytes);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

void appendRecord(std::string& bytes, const BagFields& header, std::string_view data);

// The records of all topics. The number of a connection is the index of its topic.
std::string connectionRecords(const std::vector<BagTopic>& topics);

}  // namespace saccade::client
