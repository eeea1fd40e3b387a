#include "client/formats/evt/evt_decoder.h"

namespace saccade::client {
namespace {

using namespace evt2;

class Evt2Decoder final : public WordDecoder<Word> {
 public:
  Evt2Decoder(const std::string& path, std::uint64_t at) : WordDecoder(path, at, kHighBits, kLowBits) {}

 private:
  void decodeWord(Word word, Events& events) override {
    const Word type = word >> kTypeShift;
    switch (type) {
      case kOff:
      case kOn:
        if (high_us_ >= 0) add(word, static_cast<std::uint8_t>(type), events);
        break;
      case kTimeHigh:
        high_us_ = timeOf(word & ((Word{1} << kHighBits) - 1));
        break;
      case kTrigger:
      case kOthers:
      case kContinued:
        break;
      default:
        fail("has a type that EVT2 does not know");
    }
  }

  void add(Word word, std::uint8_t p, Events& events) const {
    const std::int64_t low_us = word >> kTimeShift & ((1 << kLowBits) - 1);
    events.push_back({(high_us_ + low_us) * kNsPerUs,
                      static_cast<std::uint16_t>(word >> kXShift & (kEvtEdge - 1)),
                      static_cast<std::uint16_t>(word & (kEvtEdge - 1)), p});
  }

  std::int64_t high_us_ = -1;  // -1: not known, so that an event has no time
};

}  // namespace

std::unique_ptr<EvtDecoder> makeEvt2Decoder(const std::string& path, std::uint64_t at) {
  return std::make_unique<Evt2Decoder>(path, at);
}

}  // namespace saccade::client
