#include "client/formats/common/reader.h"
#include "client/formats/ros/bag_record.h"
#include "client/formats/ros/event_array.h"
#include "fuzz/fuzz_target.h"
#include "fuzz/memory_file.h"

namespace saccade {
namespace {

const client::ReaderInfo& kBagReader = client::readerFor("a.bag");

using namespace client;
using namespace std::string_literals;

std::string message() {
  std::string bytes(12, '\0');  // number and stamp
  appendBytes<std::uint32_t>(bytes, 3);
  bytes += "cam";
  for (const std::uint32_t number : {3, 4, 2}) appendBytes<std::uint32_t>(bytes, number);
  return bytes + "\1\0\2\0\1\0\0\0\0\0\0\0\1"s + "\3\0\0\0\1\0\0\0\0\1\0\0\0"s;
}

// Without padding, so that there are more changes of the rest.
std::string seed(bool finished) {
  std::string chunk = connectionRecords({{"/e", "dvs_msgs/EventArray", std::string(kEventArrayMd5), ""}});
  const std::string connection = chunk;
  BagFields of_message(BagOp::kMessage), about(BagOp::kChunk), index(BagOp::kIndex);
  of_message.number<std::uint32_t>("conn", 0).time("time", {1, 2});
  appendRecord(chunk, of_message, message());
  about.text("compression", "none").number<std::uint32_t>("size", chunk.size());
  std::string records, head;
  appendRecord(records, about, chunk);
  appendRecord(records, index.number<std::uint32_t>("ver", 1), "");
  const std::size_t begin =
      13 + 8 + BagFields(BagOp::kBagHeader).number<std::uint64_t>("index_pos", 0).bytes().size();
  appendRecord(
      head,
      BagFields(BagOp::kBagHeader).number<std::uint64_t>("index_pos", finished ? begin + records.size() : 0),
      "");
  return "#ROSBAG V2.0\n" + head + records + (finished ? connection : "");
}

}  // namespace

const FuzzTarget& fuzzTarget() {
  static const FuzzTarget target{{seed(false), seed(true)},
                                 {"none", "lz4", "bz2", "conn=", "op=\2"s, "op=\5"s, "op=\7"s,
                                  "index_pos=", "size=", "topic=", "md5sum=", "\xff\xff\xff\xff", "\0\0\0\0"s,
                                  "\xff\xff\xff\x7f", "\x04\x22\x4d\x18"},
                                 [](std::string_view bytes) {
                                   const MemoryFile file(bytes);
                                   return accepts<FileFault>([&] {
                                     const auto reader = kBagReader.make(file.path());
                                     reader->size(), reader->leftOut();
                                     for (Events events; reader->read(events);)
                                       SACCADE_CHECK(events.size() <= 1 << 16);
                                   });
                                 },
                                 nullptr,
                                 20000};
  return target;
}

}  // namespace saccade
