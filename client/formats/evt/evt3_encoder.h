// Encodes events as EVT3: words of 16 bits, each with what has changed. Decoders are at fault unless
//   - TIME_HIGH comes first, and for each step of 4096 us, in silence too: it wraps every 16.8 s;
//   - TIME_LOW follows a TIME_HIGH, before events;
//   - a vector has all its three words, and lies within the image.
// Events of one time keep their order, so that a vector takes only events that follow each other.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "client/formats/evt/evt_words.h"
#include "saccade/wire/event.h"

namespace saccade::client {

class Evt3Encoder {
 public:
  explicit Evt3Encoder(std::uint32_t width) : width_(static_cast<int>(width)) {}

  // These append words. Times do not run back.
  void encode(const Events& events);
  void encodeTime(std::int64_t t_us);
  void encodeTimeHigh(std::int64_t t_us);  // the steps up to `t_us`

  // The next words build on none before them, and begin with the TIME_HIGH of `t_us`.
  void restart(std::int64_t t_us);

  std::string_view bytes() const;  // of the words since clear()
  void clear() { words_.clear(); }
  std::int64_t nextHigh() const { return next_high_; }  // the TIME_HIGH that comes next, without wraps

 private:
  Events::const_iterator encodeSome(Events::const_iterator event, Events::const_iterator end);
  void encodeRow(int y);
  void put(evt3::Type type, std::uint32_t content);

  const int width_;
  std::vector<evt3::Word> words_;
  std::int64_t next_high_ = 0;
  int low_ = -1, row_ = -1;  // what decoders know; -1: nothing
};

}  // namespace saccade::client
