// The cost of files of events:
//   build/dev/bin/file_speed [FILE [WIDTHxHEIGHT]]
// Takes the events of a file that `saccade convert` reads; without one, those of an edge that moves. Writes
// them in each format, and reads them where that is possible. Prints bytes per event, and CPU seconds per
// million events: the best of some rounds in turn.
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <limits>

#include "base/hash_rng.h"
#include "client/commands/source_file.h"
#include "client/formats/common/writer.h"

namespace saccade::client {
namespace {

namespace fs = std::filesystem;

constexpr int kRounds = 3;
constexpr std::int64_t kNsPerUs = 1000;
constexpr std::int64_t kPacketNs = 5'000'000;  // of a stream

struct Recorded {
  v1::Recording about;
  Events events;
};

Recorded readFile(const std::string& path, const std::string& size) {
  SourceFile source(path, size, EventFacts{.labels = true});
  Recorded recorded;
  recorded.about.set_width(source.size().width);
  recorded.about.set_height(source.size().height);
  for (Events batch; source.read(batch);)
    recorded.events.insert(recorded.events.end(), batch.begin(), batch.end());
  return recorded;
}

// A vertical edge, blurred over 32 pixels, that goes right by 500 pixels per second. As with a sensor, events
// of one microsecond are in the order of rows.
Recorded movingEdge() {
  constexpr int kWidth = 346, kHeight = 260, kBlur = 32, kPerUs = 7, kUs = 200'000, kUsPerPixel = 2000;
  Recorded recorded;
  recorded.about.set_width(kWidth);
  recorded.about.set_height(kHeight);
  for (std::uint64_t t_us = 0; t_us < kUs; ++t_us) {
    for (std::uint64_t i = 0; i < kPerUs; ++i) {
      const auto draw = [&](std::uint64_t what) { return toUnit(hashKey(hashKey(t_us, i), what)); };
      const int x = static_cast<int>(t_us / kUsPerPixel + draw(0) * kBlur);
      const int y = static_cast<int>((i + draw(1)) / kPerUs * kHeight);
      recorded.events.push_back({static_cast<std::int64_t>(t_us) * kNsPerUs, static_cast<std::uint16_t>(x),
                                 static_cast<std::uint16_t>(y), draw(2) < 0.8});
    }
  }
  return recorded;
}

// The events as the packets of a stream.
std::vector<Events> packetsOf(const Events& events) {
  std::vector<Events> packets;
  std::int64_t end_ns = 0;
  for (const Event& event : events) {
    if (packets.empty() || event.t_ns >= end_ns) {
      packets.emplace_back();
      end_ns = (event.t_ns / kPacketNs + 1) * kPacketNs;
    }
    packets.back().push_back(event);
  }
  return packets;
}

// CPU time of all threads, in seconds.
double cpuSeconds() {
  return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
}

class TemporaryFolder {
 public:
  TemporaryFolder() { fs::create_directory(path_); }
  ~TemporaryFolder() { fs::remove_all(path_); }
  std::string at(const std::string& name) const { return path_ / name; }

 private:
  const fs::path path_ = fs::temp_directory_path() / ("file_speed-" + std::to_string(getpid()));
};

struct Cost {
  double write_s = std::numeric_limits<double>::infinity();
  double read_s = std::numeric_limits<double>::infinity();
  double bytes = 0;
};

void measureWriting(const WriterInfo& format, const std::string& path, const v1::Recording& about,
                    const std::vector<Events>& packets, Cost& best) {
  const double began_s = cpuSeconds();
  const auto writer = format.make(path, about);
  for (const Events& packet : packets) writer->write(packet, packet.back().t_ns);
  writer->finish();
  best.write_s = std::min(best.write_s, cpuSeconds() - began_s);
  best.bytes = static_cast<double>(fs::file_size(path));
}

void measureReading(const ReaderInfo& format, const std::string& path, std::size_t events, Cost& best) {
  const double began_s = cpuSeconds();
  const auto reader = format.make(path);
  std::size_t count = 0;
  for (Events batch; reader->read(batch);) count += batch.size();
  best.read_s = std::min(best.read_s, cpuSeconds() - began_s);
  if (count != events) throw std::runtime_error(path + " has " + std::to_string(count) + " events");
}

const ReaderInfo* readerOf(const WriterInfo& writer) {
  const auto& table = readerTable();
  const auto found = std::find_if(table.begin(), table.end(), [&](const ReaderInfo* reader) {
    return std::string(reader->extension) == writer.extension;
  });
  return found == table.end() ? nullptr : *found;
}

void measureAll(const Recorded& recorded) {
  const std::vector<Events> packets = packetsOf(recorded.events);
  const auto count = static_cast<double>(recorded.events.size());
  std::printf("%zu events, %u x %u; CPU seconds per million events\n", recorded.events.size(),
              recorded.about.width(), recorded.about.height());
  std::printf("%-8s %12s %8s %8s\n", "format", "bytes/event", "write", "read");
  const TemporaryFolder folder;
  for (const WriterInfo* writer : writerTable()) {
    const std::string path = folder.at(std::string("events") + writer->extension);
    const ReaderInfo* reader = readerOf(*writer);
    Cost best;
    for (int round = 0; round < kRounds; ++round) {
      measureWriting(*writer, path, recorded.about, packets, best);
      if (reader) measureReading(*reader, path, recorded.events.size(), best);
    }
    std::printf("%-8s %12.2f %8.3f %8s\n", writer->name, best.bytes / count, 1e6 * best.write_s / count,
                reader ? std::to_string(1e6 * best.read_s / count).substr(0, 5).c_str() : "-");
  }
}

}  // namespace
}  // namespace saccade::client

int main(int argc, char** argv) {
  using namespace saccade::client;
  try {
    measureAll(argc > 1 ? readFile(argv[1], argc > 2 ? argv[2] : "") : movingEdge());
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "file_speed: %s\n", fault.what());
    return 1;
  }
}
