// Decodes the words of a RAW file of Prophesee.
#pragma once

#include <cstdint>
#include <cstring>
#include <limits>
#include <memory>
#include <span>
#include <string>

#include "client/formats/common/reader.h"
#include "client/formats/common/units.h"
#include "client/formats/evt/evt_words.h"

namespace saccade::client {

class EvtDecoder {
 public:
  virtual ~EvtDecoder() = default;
  // Appends the events of `bytes`, which follow those of the call before. They end with a whole word.
  // Throws FileFault with the place of a word that cannot be.
  virtual void decode(std::span<const char> bytes, Events& events) = 0;
};

// `path` for errors; `at`: the byte of the first word in the file.
std::unique_ptr<EvtDecoder> makeEvt3Decoder(const std::string& path, std::uint64_t at);
std::unique_ptr<EvtDecoder> makeEvt2Decoder(const std::string& path, std::uint64_t at);

// Shared by both decoders. TIME_HIGH has `high_bits` bits, above `low_bits` bits of microseconds.
template <class Word>
class WordDecoder : public EvtDecoder {
 public:
  WordDecoder(const std::string& path, std::uint64_t at, int high_bits, int low_bits)
      : path_(path), at_(at), high_bits_(high_bits), low_bits_(low_bits) {}

  void decode(std::span<const char> bytes, Events& events) override {
    for (std::size_t i = 0; i < bytes.size(); i += sizeof(Word), at_ += sizeof(Word)) {
      Word word;
      std::memcpy(&word, &bytes[i], sizeof(word));
      decodeWord(word, events);
    }
  }

 protected:
  // The time in microseconds that TIME_HIGH tells. A step back by at least half of its range is a wrap.
  std::int64_t timeOf(std::uint32_t high) {
    if (last_high_ >= high + (std::uint32_t{1} << (high_bits_ - 1))) ++wraps_;
    last_high_ = high;
    const std::int64_t steps = wraps_ << high_bits_ | high;
    if (steps >= std::numeric_limits<std::int64_t>::max() / kNsPerUs >> low_bits_)
      fail("is later than 292 years");
    return steps << low_bits_;
  }

  [[noreturn]] void fail(const std::string& what) const {
    throw FileFault(path_, "the word at byte " + std::to_string(at_) + " " + what);
  }

 private:
  virtual void decodeWord(Word word, Events& events) = 0;

  const std::string path_;
  std::uint64_t at_;  // byte
  const int high_bits_, low_bits_;
  std::uint32_t last_high_ = 0;
  std::int64_t wraps_ = 0;
};

}  // namespace saccade::client
