// The payloads of truth channels. Numbers are little-endian.
//
// LAYOUT_PICTURE: the planes of one sample, each row by row from the top.
// LAYOUT_ROWS: u32 dt[count], in dt_unit_ns since t0_ns | the elements of each sample, one sample after the
// other.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "saccade/v1/events.pb.h"

namespace saccade {

inline constexpr std::uint32_t kMaxPicturePlanes = 4, kMaxRowElements = 16;
inline constexpr std::uint32_t kMaxPacketRows = 32768;

// A picture, or one row.
struct TruthSample {
  std::int64_t t_ns = 0;                                    // stream time, a multiple of kTimeUnitNs
  std::string elements;                                     // as in the payload
  std::int64_t exposure_begin_ns = 0, exposure_end_ns = 0;  // of a picture that was exposed

  friend bool operator==(const TruthSample&, const TruthSample&) = default;
};
using TruthSamples = std::vector<TruthSample>;  // in time order

std::size_t bytesOf(v1::Element element);  // 0 if it is unknown

// Bytes of the elements of one sample, or 0 if the header describes none.
std::uint64_t sampleBytes(const v1::PacketHeader& header);
// Bytes of the whole payload.
std::uint64_t truthBytes(const v1::PacketHeader& header);

// The payload of a packet that begins at t0_ns.
std::string encodeTruth(std::span<const TruthSample> samples, v1::Layout layout, std::int64_t t0_ns);

// For receivers; the header may hold anything. Returns an empty text, or why it is none of a truth channel.
std::string checkTruth(const v1::PacketHeader& header);
// After checkTruth(), of a payload of truthBytes(). Returns an empty text, or what is wrong.
std::string decodeTruth(const v1::PacketHeader& header, std::string payload, TruthSamples& out);

}  // namespace saccade
