#include "client/formats/ros/event_array.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "client/formats/common/byte_reader.h"
#include "client/formats/common/units.h"

namespace saccade::client {
namespace {

constexpr std::size_t kBatch = 1 << 16;  // events

Event eventOf(ByteReader& bytes) {
  const auto x = bytes.number<std::uint16_t>(), y = bytes.number<std::uint16_t>();
  const std::int64_t seconds = bytes.number<std::uint32_t>(), ns = bytes.number<std::uint32_t>();
  const std::int64_t t_ns = seconds * kNsPerSecond + ns;
  const auto p = bytes.number<std::uint8_t>();
  if (p > 1) throw std::runtime_error("has an event of polarity " + std::to_string(p) + "; it is 0 or 1");
  return {t_ns - t_ns % kNsPerUs, x, y, p};
}

}  // namespace

ImageSize EventArrayDecoder::begin(std::string_view message) {
  ByteReader bytes(message);
  for (int i = 0; i < 3; ++i) bytes.number<std::uint32_t>();  // number and stamp
  bytes.sized();                                              // frame
  const auto height = bytes.number<std::uint32_t>(), width = bytes.number<std::uint32_t>();
  const std::uint64_t size = bytes.number<std::uint32_t>() * std::uint64_t{kEventArrayEventBytes};
  left_ = bytes.part(size);
  if (!bytes.atEnd()) throw std::runtime_error("has a message that is longer than its events");
  return {width, height};
}

bool EventArrayDecoder::append(Events& events) {
  const std::size_t count = std::min(kBatch, left_.size() / kEventArrayEventBytes);
  ByteReader bytes(left_);
  for (std::size_t i = 0; i < count; ++i) events.push_back(eventOf(bytes));
  left_.remove_prefix(bytes.at());
  return count > 0;
}

}  // namespace saccade::client
