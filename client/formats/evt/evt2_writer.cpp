// EVT2 in a RAW file of Prophesee: a word of 32 bits per event, and TIME_HIGH when the time above its lower 6
// bits changes. TIME_HIGH wraps after 4 h 46 min: its last and its first value show each wrap to decoders.
// (The HAL of OpenEB 5.1.1 misses it all the same, if more than 10 ms of events come in one buffer.)
#include <stdexcept>

#include "client/formats/common/units.h"
#include "client/formats/common/writer.h"
#include "client/formats/evt/evt_words.h"
#include "client/formats/evt/raw_header.h"

namespace saccade::client {
namespace {

using namespace evt2;

constexpr Word kHighMask = (Word{1} << kHighBits) - 1;
constexpr std::int64_t kLowMask = (1 << kLowBits) - 1;

class Evt2Writer final : public Writer {
 public:
  Evt2Writer(const std::string& path, const std::string& header) : file_(path) {
    file_.append(header);
    putTimeHigh(0);
  }

  void write(const Events& events, std::int64_t until_ns) override {
    if (!events.empty() && events.front().t_ns < 0)
      throw std::range_error("EVT2 has no times before 0, as " +
                             std::to_string(events.front().t_ns / kNsPerUs) + " us is");
    for (const Event& event : events) encode(event);
    encodeTimeHigh(until_ns / kNsPerUs >> kLowBits);
    file_.append({reinterpret_cast<const char*>(words_.data()), words_.size() * sizeof(Word)});
    words_.clear();
  }

  void finish() override { file_.close(); }

 private:
  void encode(const Event& event) {
    const std::int64_t t_us = event.t_ns / kNsPerUs;
    encodeTimeHigh(t_us >> kLowBits);
    words_.push_back((event.p ? kOn : kOff) << kTypeShift | static_cast<Word>(t_us & kLowMask) << kTimeShift |
                     Word{event.x} << kXShift | event.y);
  }

  void encodeTimeHigh(std::int64_t high) {
    if (high <= high_) return;
    for (auto wraps = (high >> kHighBits) - (high_ >> kHighBits); wraps > 0; --wraps) {
      putTimeHigh(kHighMask);
      putTimeHigh(0);
    }
    putTimeHigh(static_cast<Word>(high & kHighMask));
    high_ = high;
  }

  void putTimeHigh(Word content) { words_.push_back(kTimeHigh << kTypeShift | content); }

  OutputFile file_;
  std::vector<Word> words_;
  std::int64_t high_ = 0;  // without wraps
};

std::unique_ptr<Writer> make(const std::string& path, const v1::Recording& about) {
  return std::make_unique<Evt2Writer>(path, rawHeader("2.0", "EVT2", about));
}

}  // namespace

extern const WriterInfo kEvt2Writer{
    .name = "evt2", .extension = ".raw", .description = "EVT2 of Prophesee", .make = make, .wraps = true};

}  // namespace saccade::client
