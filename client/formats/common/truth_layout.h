// Samples of a truth channel as files hold them.
#pragma once

#include <cstdint>
#include <string>

#include "saccade/v1/recording.pb.h"

namespace saccade::client {

inline bool isPicture(const v1::RecordedTruth& channel) {
  return channel.info().layout() == v1::LAYOUT_PICTURE;
}

// For WriterInfo::truth.
inline bool holdsAllTruth(const v1::RecordedTruth&) {
  return true;
}

std::uint32_t planesOf(const v1::RecordedTruth& channel);
std::uint64_t sampleBytes(const v1::RecordedTruth& channel);

// The elements of a sample with the planes innermost: [height, width, planes] of a picture, [planes] of a
// row.
std::string interleaved(const v1::RecordedTruth& channel, const std::string& elements);

}  // namespace saccade::client
