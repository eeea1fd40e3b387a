#include "client/formats/evt/evt_decoder.h"

namespace saccade::client {
namespace {

using namespace evt3;

class Evt3Decoder final : public WordDecoder<Word> {
 public:
  Evt3Decoder(const std::string& path, std::uint64_t at) : WordDecoder(path, at, kTimeBits, kTimeBits) {}

 private:
  void decodeWord(Word word, Events& events) override {
    const std::uint32_t content = word & 0xfff;
    switch (word >> kTypeShift) {
      case kAddrY:
        y_ = static_cast<int>(content & (kEvtEdge - 1));
        break;
      case kAddrX:
        add(content & (kEvtEdge - 1), content >> kPolarityShift, events);
        break;
      case kVectBaseX:
        base_ = content & (kEvtEdge - 1);
        vector_p_ = content >> kPolarityShift;
        break;
      case kVect12:
        addVector(content, 12, events);
        break;
      case kVect8:
        addVector(content & 0xff, 8, events);
        break;
      case kTimeLow:
        low_us_ = content;
        break;
      case kTimeHigh:
        setTimeHigh(content);
        break;
      case kContinued4:
      case kTrigger:
      case kImu:
      case kOthers:
      case kContinued12:
        break;
      default:
        fail("has a type that EVT3 does not know");
    }
  }

  void setTimeHigh(std::uint32_t content) {
    const std::int64_t high_us = timeOf(content);
    if (high_us != high_us_) low_us_ = 0;
    high_us_ = high_us;
  }

  // Before the first TIME_HIGH and ADDR_Y an event has no time or no row.
  void add(std::uint32_t x, std::uint32_t p, Events& events) const {
    if (high_us_ < 0 || y_ < 0) return;
    events.push_back({(high_us_ + low_us_) * kNsPerUs, static_cast<std::uint16_t>(x),
                      static_cast<std::uint16_t>(y_), static_cast<std::uint8_t>(p)});
  }

  void addVector(std::uint32_t columns, std::uint32_t width, Events& events) {
    if (columns != 0 && base_ >= kEvtEdge) fail("is a vector beyond column 2047");
    for (std::uint32_t x = base_; columns != 0; ++x, columns >>= 1) {
      if (columns & 1) add(x, vector_p_, events);
    }
    if (base_ < kEvtEdge) base_ += width;
  }

  std::int64_t high_us_ = -1, low_us_ = 0;  // their sum is the time; -1: not known
  int y_ = -1;                              // -1: not known
  std::uint32_t base_ = 0, vector_p_ = 0;
};

}  // namespace

std::unique_ptr<EvtDecoder> makeEvt3Decoder(const std::string& path, std::uint64_t at) {
  return std::make_unique<Evt3Decoder>(path, at);
}

}  // namespace saccade::client
