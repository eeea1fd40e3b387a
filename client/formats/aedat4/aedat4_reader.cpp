// AEDAT 4, the format of DV and dv-processing. The reader takes the first stream of events, and passes over
// the others.
//
// Times are those in the file, which cameras count from 1970. `tsOffset` is not added: it is in them already.
#include <algorithm>
#include <stdexcept>

#include "client/formats/aedat4/packet_file.h"
#include "client/formats/aedat4/packets.h"
#include "client/formats/common/reader.h"

namespace saccade::client {
namespace {

using namespace aedat4;

constexpr std::size_t kBatch = 1 << 16;  // events

class Aedat4Reader : public Reader {
 public:
  explicit Aedat4Reader(const std::string& path) : file_(path), stream_(findEvents(path)) {}

  ImageSize size() const override { return stream_.size; }
  std::string leftOut() const override;
  bool read(Events& events) override;

 private:
  const Stream& findEvents(const std::string& path) const;
  bool nextPacket();

  PacketFile file_;
  const Stream& stream_;
  Events packet_;
  std::size_t next_ = 0;  // of packet_
};

const Stream& Aedat4Reader::findEvents(const std::string& path) const {
  for (const Stream& stream : file_.streams()) {
    if (stream.type == kEventsType) return stream;
  }
  throw FileFault(path, "has no stream of events (EVTS)");
}

std::string Aedat4Reader::leftOut() const {
  std::string names;
  for (const Stream& stream : file_.streams()) {
    if (&stream == &stream_) continue;
    names += (names.empty() ? "stream " : ", stream ") + std::to_string(stream.id) + " (" + stream.type + ")";
  }
  return names;
}

// At most the events of one packet, so that those before a fault are read.
bool Aedat4Reader::read(Events& events) {
  events.clear();
  while (next_ == packet_.size()) {
    if (!nextPacket()) return false;
  }
  const std::size_t end = std::min(packet_.size(), next_ + kBatch);
  const auto first = packet_.begin();
  events.assign(first + static_cast<std::ptrdiff_t>(next_), first + static_cast<std::ptrdiff_t>(end));
  next_ = end;
  return true;
}

// Reads the next packet; of another stream nothing.
bool Aedat4Reader::nextPacket() {
  packet_.clear();
  next_ = 0;
  const auto packet = file_.next();
  if (!packet) return false;
  if (packet->stream != &stream_) return true;
  const std::string& content = file_.content(*packet);
  try {
    appendEvents(packet_, content);
  } catch (const std::runtime_error& fault) {
    file_.fail(*packet, fault.what());
  }
  return true;
}

std::unique_ptr<Reader> make(const std::string& path) {
  return std::make_unique<Aedat4Reader>(path);
}

}  // namespace

extern const ReaderInfo kAedat4Reader{".aedat4", "AEDAT 4, the first stream of events", make};

}  // namespace saccade::client
