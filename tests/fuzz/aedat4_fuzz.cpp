#include "client/formats/aedat4/info_node.h"
#include "client/formats/aedat4/io_header.h"
#include "client/formats/aedat4/packets.h"
#include "client/formats/common/reader.h"
#include "fuzz/fuzz_target.h"
#include "fuzz/memory_file.h"

namespace saccade {
namespace {

const client::ReaderInfo& kAedat4Reader = client::readerFor("a.aedat4");

using namespace client::aedat4;

// Short, so that there are more changes of the rest.
constexpr const char* kInfo =
    "<dv><node name=\"outInfo\"><node name=\"0\"><attr key=\"typeIdentifier\">EVTS</attr></node></node></dv>";

std::string seed(Compression compression, bool finished) {
  const Events events{{0, 1, 2, 1}, {1000, 3, 2, 0}, {2000, 0, 0, 1}};
  IoHeader header{compression, kNoTable, kInfo};
  std::string packets;
  PacketEncoder(compression).append(packets, events);
  PacketEncoder(compression).append(packets, {events.data(), 1});
  if (finished)
    header.table_position =
        static_cast<std::int64_t>(kMagic.size() + encodeHeader(header).size() + packets.size());
  return std::string(kMagic) + encodeHeader(header) + packets + (finished ? "table" : "");
}

}  // namespace

const FuzzTarget& fuzzTarget() {
  static const FuzzTarget target{
      {seed(Compression::kNone, false), seed(Compression::kNone, true), seed(Compression::kLz4, true)},
      {"EVTS", "IOHE", "FRME", "\xff\xff\xff\xff", "\xff\xff\xff\x7f", std::string(8, '\0'),
       std::string(1, 1), "sizeX", "<node name=\"1\">", "</node>", "-1", "\x04\x22\x4d\x18",
       "\x28\xb5\x2f\xfd"},
      [](std::string_view bytes) {
        const MemoryFile file(bytes);
        return accepts<client::FileFault>([&] {
          const auto reader = kAedat4Reader.make(file.path());
          for (Events events; reader->read(events);) SACCADE_CHECK(events.size() <= 1 << 16);
        });
      }};
  return target;
}

}  // namespace saccade
