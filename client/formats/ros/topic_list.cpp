#include "client/formats/ros/topic_list.h"

#include <algorithm>
#include <stdexcept>

namespace saccade::client {
namespace {

constexpr std::size_t kMostNumbers = 1 << 16, kMostName = 4096;  // bytes

}  // namespace

void TopicList::add(std::uint32_t number, const RosTopic& topic) {
  if (numbers_.contains(number)) return;
  if (numbers_.size() == kMostNumbers) throw std::runtime_error("describes more than 65536 topics");
  const auto known = std::find(topics_.begin(), topics_.end(), topic);
  numbers_[number] = static_cast<std::size_t>(known - topics_.begin());
  if (known == topics_.end()) topics_.push_back(topic);
}

std::size_t TopicList::find(std::uint32_t number) const {
  const auto known = numbers_.find(number);
  if (known == numbers_.end()) throw std::runtime_error("has a message of a topic that it does not describe");
  return known->second;
}

std::string TopicList::checked(std::string_view name) {
  if (name.size() > kMostName) throw std::runtime_error("has a name of more than 4 KiB");
  return std::string(name);
}

}  // namespace saccade::client
