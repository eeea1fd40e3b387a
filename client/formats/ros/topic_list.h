// The topics of a file of ROS, and the numbers by which its messages name them.
#pragma once

#include <cstdint>
#include <map>
#include <vector>

#include "client/formats/ros/ros_source.h"

namespace saccade::client {

class TopicList {
 public:
  // A number that is known keeps its topic. Several numbers may be of one topic. Throws std::runtime_error
  // for more than 65536 numbers.
  void add(std::uint32_t number, const RosTopic& topic);
  // The index in all(). Throws std::runtime_error for a number that is not known.
  std::size_t find(std::uint32_t number) const;
  const std::vector<RosTopic>& all() const { return topics_; }

  // A name in a file. Throws std::runtime_error for more than 4 KiB.
  static std::string checked(std::string_view name);

 private:
  std::vector<RosTopic> topics_;
  std::map<std::uint32_t, std::size_t> numbers_;
};

}  // namespace saccade::client
