#include "client/formats/evt/evt3_encoder.h"
#include "client/formats/common/units.h"

#include <algorithm>

namespace saccade::client {
namespace {

using namespace evt3;

constexpr int kVectorWidth = 32, kVectorWords = 4;

bool sameRow(const Event& a, const Event& b) {
  return a.t_ns == b.t_ns && a.y == b.y && a.p == b.p;
}

}  // namespace

void Evt3Encoder::encode(const Events& events) {
  for (auto event = events.begin(); event != events.end();) event = encodeSome(event, events.end());
}

// Encodes a vector, or the first event alone. Returns the next event.
Events::const_iterator Evt3Encoder::encodeSome(Events::const_iterator event, Events::const_iterator end) {
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

void Evt3Encoder::encodeTime(std::int64_t t_us) {
  encodeTimeHigh(t_us);
  const int low = static_cast<int>(t_us & ((1 << kTimeBits) - 1));
  if (low != low_) put(kTimeLow, low);
  low_ = low;
}

// Readers may start at any of the steps, so that time and row are told again.
void Evt3Encoder::encodeTimeHigh(std::int64_t t_us) {
  for (; next_high_ <= t_us >> kTimeBits; ++next_high_) {
    put(kTimeHigh, static_cast<int>(next_high_ & ((1 << kTimeBits) - 1)));
    low_ = row_ = -1;
  }
}

void Evt3Encoder::restart(std::int64_t t_us) {
  next_high_ = t_us >> kTimeBits;
  low_ = row_ = -1;
}

std::string_view Evt3Encoder::bytes() const {
  return {reinterpret_cast<const char*>(words_.data()), words_.size() * sizeof(Word)};
}

void Evt3Encoder::encodeRow(int y) {
  if (y != row_) put(kAddrY, y);
  row_ = y;
}

void Evt3Encoder::put(Type type, std::uint32_t content) {
  words_.push_back(static_cast<Word>(type << kTypeShift | content));
}

}  // namespace saccade::client
