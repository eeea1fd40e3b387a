// RAW files of Prophesee with EVT3 or EVT2. Words without events, such as triggers, are passed over, and so
// are events before the first word of time. Part of a word at the end is what a killed program leaves; it is
// passed over too.
#include <fstream>
#include <system_error>

#include "client/formats/evt/evt_decoder.h"
#include "client/formats/evt/evt_words.h"
#include "client/formats/evt/raw_header_reader.h"

namespace saccade::client {
namespace {

constexpr std::size_t kBlock = 1 << 16;  // bytes; at most 12 events per word of 2

class RawReader final : public Reader {
 public:
  explicit RawReader(const std::string& path) : path_(path), file_(path, std::ios::binary), bytes_(kBlock) {
    if (!file_) throw std::system_error(errno, std::generic_category(), path);
    const RawHeader header = readRawHeader(file_, path);
    size_ = header.size;
    file_.clear();
    const auto at = static_cast<std::uint64_t>(file_.tellg());
    if (header.encoding == "EVT3") {
      decoder_ = makeEvt3Decoder(path, at);
      word_ = sizeof(evt3::Word);
    } else if (header.encoding == "EVT2") {
      decoder_ = makeEvt2Decoder(path, at);
      word_ = sizeof(evt2::Word);
    } else {
      throw FileFault(path, "holds " + header.encoding + "; only EVT3 and EVT2 can be read");
    }
  }

  ImageSize size() const override { return size_; }

  bool read(Events& events) override {
    events.clear();
    file_.read(bytes_.data(), static_cast<std::streamsize>(bytes_.size()));
    if (file_.bad()) throw std::system_error(errno, std::generic_category(), path_);
    const auto count = static_cast<std::size_t>(file_.gcount());
    decoder_->decode(std::span(bytes_).first(count - count % word_), events);
    return count >= word_;
  }

 private:
  const std::string path_;
  std::ifstream file_;
  std::vector<char> bytes_;
  ImageSize size_;
  std::unique_ptr<EvtDecoder> decoder_;
  std::size_t word_;  // bytes
};

std::unique_ptr<Reader> make(const std::string& path) {
  return std::make_unique<RawReader>(path);
}

}  // namespace

extern const ReaderInfo kRawReader{".raw", "EVT3 or EVT2 of Prophesee", make};

}  // namespace saccade::client
