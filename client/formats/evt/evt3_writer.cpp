// EVT3 in a RAW file of Prophesee. TIME_HIGH is told in silence too.
#include <algorithm>
#include <stdexcept>

#include "client/formats/common/units.h"
#include "client/formats/common/writer.h"
#include "client/formats/evt/evt3_encoder.h"
#include "client/formats/evt/raw_header.h"

namespace saccade::client {
namespace {

constexpr std::int64_t kMaxSilenceUs = 24 * 3600 * 1'000'000LL;  // 42 MB of TIME_HIGH

class Evt3Writer final : public Writer {
 public:
  Evt3Writer(const std::string& path, const std::string& header, std::uint32_t width)
      : file_(path), encoder_(width) {
    file_.append(header);
  }

  void write(const Events& events, std::int64_t until_ns) override {
    const std::int64_t until_us = std::max(until_ns, events.empty() ? 0 : events.back().t_ns) / kNsPerUs;
    if (!events.empty()) checkTime(events.front().t_ns / kNsPerUs);
    checkTime(until_us);
    encoder_.clear();
    encoder_.encode(events);
    encoder_.encodeTimeHigh(until_us);
    file_.append(encoder_.bytes());
  }

  void finish() override { file_.close(); }

 private:
  void checkTime(std::int64_t t_us) const {
    if (t_us < 0) throw std::range_error("EVT3 has no times before 0, as " + std::to_string(t_us) + " us is");
    const std::int64_t told_us = encoder_.nextHigh() << evt3::kTimeBits;
    if (t_us - told_us > kMaxSilenceUs)
      throw std::range_error("EVT3 would need more than 42 MB for the silence from " +
                             std::to_string(told_us) + " us to " + std::to_string(t_us) +
                             " us; at most 24 hours are written");
  }

  OutputFile file_;
  Evt3Encoder encoder_;
};

std::unique_ptr<Writer> make(const std::string& path, const v1::Recording& about) {
  return std::make_unique<Evt3Writer>(path, rawHeader("3.0", "EVT3", about), about.width());
}

}  // namespace

extern const WriterInfo kEvt3Writer{
    .name = "evt3", .extension = ".raw", .description = "EVT3 of Prophesee", .make = make, .wraps = true};

}  // namespace saccade::client
