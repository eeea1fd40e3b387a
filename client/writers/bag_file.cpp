#include "client/writers/bag_file.h"

#include <system_error>

#include "client/writers/little_endian.h"

namespace saccade::client {
namespace {

enum class Op : std::uint8_t {
  kMessage = 2,
  kBagHeader = 3,
  kIndex = 4,
  kChunk = 5,
  kChunkInfo = 6,
  kConnection = 7
};

constexpr std::string_view kVersion = "#ROSBAG V2.0\n";
constexpr std::size_t kBagHeaderSize = 4096;    // bytes, without the two lengths
constexpr std::size_t kChunkSize = 768 * 1024;  // bytes after which a chunk ends, as in rosbag
constexpr std::uint32_t kIndexVersion = 1;      // of records kIndex and kChunkInfo
constexpr std::uint32_t kConnectionId = 0;

void appendTime(std::string& bytes, const RosTime& time) {
  appendBytes<std::uint32_t>(bytes, time.sec);
  appendBytes<std::uint32_t>(bytes, time.nsec);
}

void appendSized(std::string& bytes, std::string_view data) {
  appendBytes<std::uint32_t>(bytes, data.size());
  bytes += data;
}

// The fields name=value of a record's header.
class Fields {
 public:
  Fields() = default;
  explicit Fields(Op op) { number<std::uint8_t>("op", static_cast<std::uint8_t>(op)); }

  Fields& text(std::string_view name, std::string_view value) {
    appendBytes<std::uint32_t>(bytes_, name.size() + 1 + value.size());
    ((bytes_ += name) += '=') += value;
    return *this;
  }
  template <class T>
  Fields& number(std::string_view name, T value) {
    std::string bytes;
    appendBytes<T>(bytes, value);
    return text(name, bytes);
  }
  Fields& time(std::string_view name, const RosTime& time) {
    std::string bytes;
    appendTime(bytes, time);
    return text(name, bytes);
  }
  const std::string& bytes() const { return bytes_; }

 private:
  std::string bytes_;
};

void appendRecord(std::string& bytes, const Fields& header, std::string_view data) {
  appendSized(bytes, header.bytes());
  appendSized(bytes, data);
}

std::string connectionRecord(const BagTopic& topic) {
  Fields header(Op::kConnection), data;
  header.number("conn", kConnectionId).text("topic", topic.name);
  data.text("topic", topic.name).text("type", topic.type).text("md5sum", topic.md5sum);
  data.text("message_definition", topic.definition);
  std::string record;
  appendRecord(record, header, data.bytes());
  return record;
}

// Padded, so that its size stays the same when the numbers are known. While `index_position` is 0, readers
// take the bag for one that was not closed.
std::string bagHeader(std::uint64_t index_position, std::uint32_t connections, std::uint32_t chunks) {
  Fields header(Op::kBagHeader);
  header.number("index_pos", index_position).number("conn_count", connections).number("chunk_count", chunks);
  std::string record;
  appendRecord(record, header, std::string(kBagHeaderSize - header.bytes().size(), ' '));
  return record;
}

}  // namespace

void appendChunkInfo(std::string& records, const BagChunk& chunk) {
  Fields header(Op::kChunkInfo);
  header.number("ver", kIndexVersion).number("chunk_pos", chunk.position);
  header.time("start_time", chunk.begin).time("end_time", chunk.end);
  header.number<std::uint32_t>("count", 1);  // of connections in the data
  std::string data;
  appendBytes<std::uint32_t>(data, kConnectionId);
  appendBytes<std::uint32_t>(data, chunk.messages);
  appendRecord(records, header, data);
}

BagFile::BagFile(const std::string& path, const BagTopic& topic)
    : file_(path), connection_(connectionRecord(topic)), chunk_(connection_) {
  file_.append(std::string(kVersion) + bagHeader(0, 0, 0));
}

void BagFile::add(const RosTime& time, std::string_view message, std::uint64_t events) {
  if (about_.messages++ == 0) about_.begin = time;
  about_.end = time;
  appendTime(entries_, time);
  appendBytes<std::uint32_t>(entries_, chunk_.size());
  Fields header(Op::kMessage);
  header.number("conn", kConnectionId).time("time", time);
  appendRecord(chunk_, header, message);
  events_ += events;
  if (chunk_.size() >= kChunkSize) writeChunk();
}

void BagFile::writeChunk() {
  Fields header(Op::kChunk), index(Op::kIndex);
  header.text("compression", "none").number<std::uint32_t>("size", chunk_.size());
  index.number("ver", kIndexVersion).number("conn", kConnectionId).number("count", about_.messages);
  std::string records;
  appendRecord(records, header, chunk_);
  appendRecord(records, index, entries_);
  about_.position = file_.size();
  file_.appendChunk(records, events_);
  appendChunkInfo(chunk_infos_, about_);
  ++chunk_count_;
  about_ = {};
  events_ = 0;
  chunk_.clear(), entries_.clear();
}

void BagFile::writeIndex() {
  const std::uint64_t position = file_.size();
  file_.append(connection_ + chunk_infos_);
  file_.overwrite(kVersion.size(), bagHeader(position, 1, chunk_count_));
}

void BagFile::finish() {
  if (about_.messages > 0) writeChunk();
  writeIndex();
  file_.close();
  finished_ = true;
}

BagFile::~BagFile() {
  if (finished_) return;
  try {
    writeIndex();
  } catch (const std::system_error&) {
    // The fault that kept the file from being finished is being told already.
  }
}

}  // namespace saccade::client
