// AEDAT 4, the format of DV and dv-processing: a header, packets of events, and a table of the packets.
//
// Times are those of the stream, in microseconds. A packet holds the events of 5 ms of the stream, or 65536
// of them. So the file depends on the events alone, and not on the batches in which they come.
#include <algorithm>
#include <span>
#include <stdexcept>

#include "client/formats/aedat4/info_node.h"
#include "client/formats/aedat4/io_header.h"
#include "client/formats/aedat4/packet_table.h"
#include "client/formats/common/message_splitter.h"
#include "client/formats/common/units.h"
#include "client/formats/common/writer.h"

namespace saccade::client {
namespace {

using namespace aedat4;

constexpr Compression kCompression = Compression::kLz4;
constexpr std::uint32_t kMostPixels = 32767;  // coordinates and sizes are of 16 bits with a sign

// How many of the first events make a packet; 0: more may belong to it. No event before `until_ns` will
// follow.
std::size_t packetSize(std::span<const Event> events, std::int64_t until_ns) {
  if (events.empty()) return 0;
  const std::int64_t end = intervalEnd(events.front().t_ns);
  const auto later = std::partition_point(events.begin(), events.end(),
                                          [=](const Event& event) { return event.t_ns < end; });
  const auto size = std::min<std::size_t>(later - events.begin(), kMostMessageEvents);
  return size < events.size() || size == kMostMessageEvents || until_ns >= end ? size : 0;
}

class Aedat4Writer : public Writer {
 public:
  Aedat4Writer(const std::string& path, const Camera& camera)
      : file_(path), header_{kCompression, kNoTable, fileInfo(camera, kCompression)} {
    file_.append(std::string(kMagic) + encodeHeader(header_));
  }

  void write(const Events& events, std::int64_t until_ns) override;
  void finish() override;
  std::uint64_t kept(std::uint64_t) const override { return kept_; }

 private:
  void appendPackets(std::int64_t until_ns);
  void appendTable();

  OutputFile file_;
  IoHeader header_;
  PacketEncoder encoder_{kCompression};
  PacketTable table_;
  Events due_;              // not in a packet yet
  std::uint64_t kept_ = 0;  // events in packets
};

void Aedat4Writer::write(const Events& events, std::int64_t until_ns) {
  const std::size_t earlier = due_.size();
  due_.insert(due_.end(), events.begin(), events.end());
  try {
    appendPackets(until_ns);
  } catch (...) {
    due_.resize(earlier);  // for finish()
    throw;
  }
}

void Aedat4Writer::finish() {
  appendPackets(INT64_MAX);
  if (table_.whole()) appendTable();
  file_.close();
}

// Appends the packets of due_ that are complete, all or none.
void Aedat4Writer::appendPackets(std::int64_t until_ns) {
  std::string bytes;
  std::vector<PacketTable::Entry> entries;
  std::span<const Event> rest = due_;
  while (const std::size_t size = packetSize(rest, until_ns)) {
    const std::uint64_t start = file_.size() + bytes.size() + sizeof(PacketHeader);
    const PacketHeader packet = encoder_.append(bytes, rest.first(size));
    entries.push_back({static_cast<std::int64_t>(start), packet, static_cast<std::int64_t>(size),
                       rest.front().t_ns / kNsPerUs, rest[size - 1].t_ns / kNsPerUs});
    rest = rest.subspan(size);
  }
  file_.append(bytes);
  for (const PacketTable::Entry& entry : entries) table_.add(entry);
  kept_ += due_.size() - rest.size();
  due_.erase(due_.begin(), due_.end() - static_cast<std::ptrdiff_t>(rest.size()));
}

// The table has no packet header of its own.
void Aedat4Writer::appendTable() {
  std::string table;
  Compressor(kCompression).append(table, table_.encode());
  header_.table_position = static_cast<std::int64_t>(file_.size());
  file_.append(table);
  file_.overwrite(kMagic.size(), encodeHeader(header_));
}

std::unique_ptr<Writer> make(const std::string& path, const v1::Recording& about) {
  if (std::max(about.width(), about.height()) > kMostPixels)
    throw std::invalid_argument("AEDAT 4 holds images of at most 32767x32767 pixels, not " +
                                std::to_string(about.width()) + "x" + std::to_string(about.height()));
  return std::make_unique<Aedat4Writer>(path, Camera{{about.width(), about.height()}, about.sensor()});
}

}  // namespace

extern const WriterInfo kAedat4Writer{"aedat4", ".aedat4", "AEDAT 4, as DV and dv-processing read it", make};

}  // namespace saccade::client
