#include "client/formats/ros/event_packet.h"

#include <algorithm>
#include <stdexcept>

#include "client/formats/ros/cdr_reader.h"

namespace saccade::client {
namespace {

constexpr std::size_t kBatch = 1 << 16;  // bytes; at most 12 events per word of 2
constexpr std::int64_t kWrapUs = std::int64_t{1} << 2 * evt3::kTimeBits;

}  // namespace

EventPacketDecoder::EventPacketDecoder(const std::string& path)
    : decoder_(makeEvt3Decoder(path + ": EVT3", 0)) {}

ImageSize EventPacketDecoder::begin(std::string_view message) {
  CdrReader cdr(message);
  const std::int64_t seconds = cdr.number<std::int32_t>();
  stamp_us_ = seconds * (kNsPerSecond / kNsPerUs) + cdr.number<std::uint32_t>() / kNsPerUs;
  cdr.text();  // frame
  const auto height = cdr.number<std::uint32_t>(), width = cdr.number<std::uint32_t>();
  for (int i = 0; i < 2; ++i) cdr.number<std::uint64_t>();  // number, and a time that EVT3 does not use
  const std::string encoding(cdr.text());
  if (encoding != "evt3")
    throw std::runtime_error("has events in the encoding '" + encoding + "'; evt3 can be read");
  if (cdr.number<std::uint8_t>() != 0) throw std::runtime_error("has events that are big-endian");
  left_ = cdr.octets();
  left_.remove_suffix(left_.size() % sizeof(evt3::Word));
  return {width, height};
}

bool EventPacketDecoder::append(Events& events) {
  if (left_.empty()) return false;
  const std::size_t size = std::min(kBatch, left_.size()), first = events.size();
  decoder_->decode(std::span(left_.data(), size), events);
  left_.remove_prefix(size);
  if (first == events.size()) return true;
  if (!before_ns_) {
    const std::int64_t gap_us = stamp_us_ - events[first].t_ns / kNsPerUs;
    before_ns_ = gap_us > 0 && gap_us % kWrapUs == 0 ? gap_us * kNsPerUs : 0;
  }
  for (std::size_t i = first; i < events.size(); ++i) events[i].t_ns += *before_ns_;
  return true;
}

}  // namespace saccade::client
