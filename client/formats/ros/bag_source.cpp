#include "client/formats/ros/bag_source.h"

#include <algorithm>
#include <utility>

#include "client/formats/common/expand.h"
#include "client/formats/ros/event_array.h"

namespace saccade::client {
namespace {

constexpr std::string_view kVersion = "#ROSBAG V2.0\n", kAnyVersion = "#ROSBAG V";
constexpr std::uint32_t kMostHeader = 1 << 20;  // bytes of a record's header

}  // namespace

BagSource::BagSource(const std::string& path) : RosSource(path) {
  placed([this] {
    readBagHeader();
    findTopics();
  });
}

void BagSource::readBagHeader() {
  const std::string version = bytesAt(0, std::min<std::uint64_t>(end_, kVersion.size()));
  if (version != kVersion)
    throw FileFault(file_.path(), version.starts_with(kAnyVersion)
                                      ? "is a bag of another version than 2.0; `rosbag fix` rewrites it"
                                      : "does not begin as a bag of ROS 1 does");
  at_ = kVersion.size();
  const auto record = nextRecord(end_);
  if (!record) fail("is not whole");
  const BagRecordFields fields(record->header);
  if (fields.op() != BagOp::kBagHeader) fail("is not the header of a bag");
  const auto index = fields.number<std::uint64_t>("index_pos");
  if (index != 0 && (index < at_ || index > end_))
    fail("says that the index is at byte " + std::to_string(index));
  begin_ = at_;
  finished_ = index != 0;
  if (finished_) end_ = index;
}

// From the index, or without one from all chunks.
void BagSource::findTopics() {
  at_ = end_;
  while (const auto record = finished_ ? nextRecord(file_.size()) : std::nullopt) {
    const BagRecordFields fields(record->header);
    if (fields.op() != BagOp::kConnection) break;
    addTopic(fields, bytesAt(record->data, record->size));
  }
  at_ = begin_;
  if (!topics_.all().empty()) return;
  while (nextMessage()) continue;
  at_ = begin_;
}

// The number at byte `at`, if so many bytes follow it before `end`.
std::optional<std::uint32_t> BagSource::sizeAt(std::uint64_t at, std::uint64_t end) {
  if (!InputFile::holds(at, sizeof(std::uint32_t), end)) return std::nullopt;
  const auto size = ByteReader(bytesAt(at, sizeof(std::uint32_t))).number<std::uint32_t>();
  return InputFile::holds(at + sizeof size, size, end) ? std::optional(size) : std::nullopt;
}

// Nothing at the end, and for a record that is cut off where the bag was not closed.
std::optional<BagSource::Record> BagSource::nextRecord(std::uint64_t end) {
  constexpr std::uint64_t kSize = sizeof(std::uint32_t);
  place_ = at_;
  if (at_ == end) return std::nullopt;
  const auto header = sizeAt(at_, end);
  const auto data = header ? sizeAt(at_ + kSize + *header, end) : std::nullopt;
  if (!data && finished_) fail("does not end before the index, or the end of the file");
  if (!data) return std::nullopt;
  if (*header > kMostHeader) fail("has a header of more than 1 MiB");
  Record record{bytesAt(at_ + kSize, *header), at_ + *header + 2 * kSize, *data};
  at_ = record.data + record.size;
  return record;
}

// Expands the next chunk; false at the end. A message or connection outside of chunks is one of its own, and
// other records are passed over.
bool BagSource::nextChunk() {
  chunk_.clear();
  next_ = 0;
  while (const auto record = nextRecord(end_)) {
    const BagRecordFields fields(record->header);
    const bool alone = fields.op() == BagOp::kMessage || fields.op() == BagOp::kConnection;
    if (!alone && fields.op() != BagOp::kChunk) continue;
    if (alone) {
      chunk_ = bytesAt(place_, at_ - place_);
    } else {
      expandChunk(*record, fields);
    }
    if (!chunk_.empty()) return true;
  }
  return false;
}

void BagSource::expandChunk(const Record& record, const BagRecordFields& fields) {
  const std::string compression(fields.text("compression"));
  if (compression == "bz2")
    fail("is compressed by bz2, which cannot be read here; `rosbag decompress` rewrites the bag");
  if (compression != "none" && compression != "lz4")
    fail("is compressed by '" + compression + "'; none and lz4 can be read");
  const auto size = fields.number<std::uint32_t>("size");
  if (size > kMostChunk) fail("has more than 256 MiB");
  std::string bytes = bytesAt(record.data, record.size);
  if (compression == "lz4") {
    expandLz4(chunk_, bytes, size);
  } else {
    chunk_ = std::move(bytes);
  }
  if (chunk_.size() != size) fail("has another size than it tells");
}

std::optional<RosSource::Message> BagSource::next() {
  return placed([this] { return nextMessage(); });
}

std::optional<RosSource::Message> BagSource::nextMessage() {
  while (next_ < chunk_.size() || nextChunk()) {
    ByteReader bytes(std::string_view(chunk_).substr(next_));
    const BagRecordFields fields(bytes.sized());
    const std::string_view data = bytes.sized();
    next_ += bytes.at();
    if (fields.op() == BagOp::kConnection) addTopic(fields, data);
    if (fields.op() == BagOp::kMessage)
      return Message{topics_.find(fields.number<std::uint32_t>("conn")), data};
  }
  return std::nullopt;
}

void BagSource::addTopic(const BagRecordFields& fields, std::string_view data) {
  const BagRecordFields about(data);
  const std::string sum = TopicList::checked(about.text("md5sum"));
  std::string type = TopicList::checked(about.text("type"));
  const bool events = sum == kEventArrayMd5;
  if (!events && type.ends_with("/EventArray")) type += " of another definition, " + sum;
  topics_.add(fields.number<std::uint32_t>("conn"), {TopicList::checked(fields.text("topic")), type, events});
}

}  // namespace saccade::client
