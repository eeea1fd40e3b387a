// Words of the encodings EVT3 and EVT2 of Prophesee, little-endian, as docs.prophesee.ai describes them under
// "Data Encoding Formats". The type of a word is in its upper four bits.
#pragma once

#include <cstdint>

namespace saccade::client {

inline constexpr std::uint32_t kEvtEdge = 2048;  // pixels; x and y have 11 bits

namespace evt3 {

using Word = std::uint16_t;
inline constexpr int kTypeShift = 12, kPolarityShift = 11;
inline constexpr int kTimeBits = 12;  // of TIME_LOW, in microseconds, and of TIME_HIGH above it

enum Type : Word {
  kAddrY = 0x0,
  kAddrX = 0x2,      // one event
  kVectBaseX = 0x3,  // the column of the first bit of the next vector
  kVect12 = 0x4,     // a bit per column; the base moves by 12, and by 8 below
  kVect8 = 0x5,
  kTimeLow = 0x6,
  kContinued4 = 0x7,
  kTimeHigh = 0x8,
  kTrigger = 0xA,
  kImu = 0xD,
  kOthers = 0xE,
  kContinued12 = 0xF,
};

}  // namespace evt3

namespace evt2 {

using Word = std::uint32_t;
inline constexpr int kTypeShift = 28, kTimeShift = 22, kXShift = 11;
inline constexpr int kLowBits = 6;    // of the time in an event, in microseconds
inline constexpr int kHighBits = 28;  // of TIME_HIGH above it

enum Type : Word {
  kOff = 0x0,
  kOn = 0x1,
  kTimeHigh = 0x8,
  kTrigger = 0xA,
  kOthers = 0xE,
  kContinued = 0xF,
};

}  // namespace evt2
}  // namespace saccade::client
