// EVT3 in a RAW file of Prophesee: words of 16 bits, each with what has changed. Decoders are at fault unless
//   - TIME_HIGH comes first, and for each step of 4096 us, in silence too: it wraps every 16.8 s;
//   - TIME_LOW follows a TIME_HIGH, before events;
//   - a vector has all its three words, and lies within the image.
// Events of one time keep their order, so that a vector takes only events that follow each other.
#include <algorithm>
#include <stdexcept>

#include "client/evt_words.h"
#include "client/writers/raw_header.h"
#include "client/writers/writer.h"

namespace saccade::client {
namespace {

using namespace evt3;

constexpr std::int64_t kMaxSilenceUs = 24 * 3600 * 1'000'000LL;  // 42 MB of TIME_HIGH
constexpr int kVectorWidth = 32, kVectorWords = 4;

bool sameRow(const Event& a, const Event& b) {
  return a.t_ns == b.t_ns && a.y == b.y && a.p == b.p;
}

class Evt3Writer final : public Writer {
 public:
  Evt3Writer(const std::string& path, const std::string& header, std::uint32_t width)
      : width_(static_cast<int>(width)), file_(path) {
    file_.append(header);
  }

  void write(const Events& events, std::int64_t until_ns) override {
    const std::int64_t until_us = std::max(until_ns, events.empty() ? 0 : events.back().t_ns) / kNsPerUs;
    if (!events.empty()) checkTime(events.front().t_ns / kNsPerUs);
    checkTime(until_us);
    words_.clear();
    for (auto event = events.begin(); event != events.end();) event = encode(event, events.end());
    encodeTimeHigh(until_us);
    file_.append({reinterpret_cast<const char*>(words_.data()), words_.size() * sizeof(Word)});
  }

  void finish() override { file_.close(); }

 private:
  void checkTime(std::int64_t t_us) const {
    if (t_us < 0) throw std::range_error("EVT3 has no times before 0, as " + std::to_string(t_us) + " us is");
    const std::int64_t told_us = next_high_ << kTimeBits;
    if (t_us - told_us > kMaxSilenceUs)
      throw std::range_error("EVT3 would need more than 42 MB for the silence from " +
                             std::to_string(told_us) + " us to " + std::to_string(t_us) +
                             " us; at most 24 hours are written");
  }

  // Encodes a vector, or the first event alone. Returns the next event.
  Events::const_iterator encode(Events::const_iterator event, Events::const_iterator end) {
    encodeTime(event->t_ns / kNsPerUs);
    encodeRow(event->y);
    const int base = std::min<int>(event->x, width_ - kVectorWidth);
    std::uint32_t columns = 0;
    auto next = event;
    do {
      columns |= 1u << (next->x - base);
      ++next;
    } while (next != end && sameRow(*next, *event) && next->x > next[-1].x && next->x < base + kVectorWidth);
    if (base < 0 || next - event <= kVectorWords) {
      put(kAddrX, event->p << kPolarityShift | event->x);
      return event + 1;
    }
    put(kVectBaseX, event->p << kPolarityShift | base);
    put(kVect12, columns & 0xfff);
    put(kVect12, columns >> 12 & 0xfff);
    put(kVect8, columns >> 24);
    return next;
  }

  void encodeTime(std::int64_t t_us) {
    encodeTimeHigh(t_us);
    const int low = static_cast<int>(t_us & ((1 << kTimeBits) - 1));
    if (low != low_) put(kTimeLow, low);
    low_ = low;
  }

  // All steps up to `t_us`. Readers may start at any of them, so that time and row are told again.
  void encodeTimeHigh(std::int64_t t_us) {
    for (; next_high_ <= t_us >> kTimeBits; ++next_high_) {
      put(kTimeHigh, static_cast<int>(next_high_ & ((1 << kTimeBits) - 1)));
      low_ = row_ = -1;
    }
  }

  void encodeRow(int y) {
    if (y != row_) put(kAddrY, y);
    row_ = y;
  }

  void put(Type type, std::uint32_t content) {
    words_.push_back(static_cast<Word>(type << kTypeShift | content));
  }

  const int width_;
  OutputFile file_;
  std::vector<Word> words_;
  std::int64_t next_high_ = 0;  // without wraps
  int low_ = -1, row_ = -1;     // what decoders know; -1: nothing
};

std::unique_ptr<Writer> make(const std::string& path, const v1::Recording& about) {
  return std::make_unique<Evt3Writer>(path, rawHeader("3.0", "EVT3", about), about.width());
}

}  // namespace

const WriterInfo kEvt3Writer{"evt3", ".raw", "EVT3 of Prophesee", make};

}  // namespace saccade::client
