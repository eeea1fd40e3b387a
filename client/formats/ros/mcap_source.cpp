#include "client/formats/ros/mcap_source.h"

#include <algorithm>

#include "client/formats/common/expand.h"
#include "client/formats/ros/event_packet.h"

namespace saccade::client {
namespace {

constexpr std::uint64_t kRecordHead = 9;   // op and length, bytes
constexpr std::uint64_t kFooterSize = 20;  // bytes

void expand(std::string& to, std::string_view bytes, std::string_view compression, std::size_t most) {
  if (compression.empty()) {
    to.assign(bytes);
  } else if (compression == "lz4") {
    expandLz4(to, bytes, most);
  } else if (compression == "zstd") {
    expandZstd(to, bytes, most);
  } else {
    throw std::runtime_error("is compressed by '" + std::string(compression) + "'; lz4 and zstd can be read");
  }
}

}  // namespace

McapSource::McapSource(const std::string& path) : RosSource(path) {
  if (bytesAt(0, std::min<std::uint64_t>(end_, kMcapMagic.size())) != kMcapMagic)
    throw FileFault(path, "does not begin as MCAP does");
  placed([this] {
    readFooter();
    findTopics();
  });
}

// A file that was finished ends with its footer and the magic bytes.
void McapSource::readFooter() {
  constexpr std::uint64_t kTail = kRecordHead + kFooterSize + kMcapMagic.size();
  if (end_ < kMcapMagic.size() + kTail) return;
  place_ = end_ - kTail;
  const std::string tail = bytesAt(place_, kTail);
  ByteReader bytes(tail);
  finished_ = tail.ends_with(kMcapMagic) &&
              bytes.number<std::uint8_t>() == static_cast<std::uint8_t>(McapOp::kFooter) &&
              bytes.number<std::uint64_t>() == kFooterSize;
  if (!finished_) return;
  summary_ = bytes.number<std::uint64_t>();
  if (summary_ != 0 && (summary_ < kMcapMagic.size() || summary_ > place_))
    fail("says that the summary is at byte " + std::to_string(summary_));
  end_ = place_;
}

// From the summary, or without one from the whole file.
void McapSource::findTopics() {
  at_ = summary_;
  while (const auto record = summary_ ? nextRecord() : std::nullopt) {
    if (record->op != McapOp::kSchema && record->op != McapOp::kChannel) continue;
    describe(record->op, bytesAt(record->content, record->size));
  }
  at_ = kMcapMagic.size();
  if (!topics_.all().empty()) return;
  while (nextMessage()) continue;
  at_ = kMcapMagic.size();
}

// Nothing at the end, and for a record that is cut off in a file that was not finished.
std::optional<McapSource::Record> McapSource::nextRecord() {
  place_ = at_;
  if (at_ == end_) return std::nullopt;
  if (InputFile::holds(at_, kRecordHead, end_)) {
    const std::string head = bytesAt(at_, kRecordHead);
    ByteReader bytes(head);
    const auto op = static_cast<McapOp>(bytes.number<std::uint8_t>());
    const Record record{op, at_ + kRecordHead, bytes.number<std::uint64_t>()};
    if (InputFile::holds(record.content, record.size, end_)) {
      at_ = record.content + record.size;
      return record;
    }
  }
  if (finished_) fail("does not end before the footer");
  return std::nullopt;
}

// Expands the next chunk; false at the end. A schema, channel or message outside of chunks is one of its own,
// and other records are passed over.
bool McapSource::nextChunk() {
  chunk_.clear();
  next_ = 0;
  for (auto record = nextRecord(); record && record->op != McapOp::kDataEnd; record = nextRecord()) {
    switch (record->op) {
      case McapOp::kChunk:
        expandChunk(bytesAt(record->content, record->size));
        if (!chunk_.empty()) return true;
        break;
      case McapOp::kSchema:
      case McapOp::kChannel:
      case McapOp::kMessage:
        chunk_ = bytesAt(place_, at_ - place_);
        return true;
      default:
        break;
    }
  }
  return false;
}

void McapSource::expandChunk(std::string_view content) {
  ByteReader bytes(content);
  for (int i = 0; i < 2; ++i) bytes.number<std::uint64_t>();  // times of its messages
  const auto size = bytes.number<std::uint64_t>();
  const auto crc = bytes.number<std::uint32_t>();
  const std::string_view compression = bytes.sized();
  if (size > kMostChunk) fail("has more than 256 MiB");
  expand(chunk_, bytes.part(bytes.number<std::uint64_t>()), compression, size);
  if (chunk_.size() != size) fail("has another size than it tells");
  if (crc != 0 && crc != mcapCrc(chunk_)) fail("does not have the CRC that it tells");
}

std::optional<RosSource::Message> McapSource::next() {
  return placed([this] { return nextMessage(); });
}

std::optional<RosSource::Message> McapSource::nextMessage() {
  while (next_ < chunk_.size() || nextChunk()) {
    ByteReader bytes(std::string_view(chunk_).substr(next_));
    const auto op = static_cast<McapOp>(bytes.number<std::uint8_t>());
    const std::string_view content = bytes.part(bytes.number<std::uint64_t>());
    next_ += bytes.at();
    describe(op, content);
    if (op != McapOp::kMessage) continue;
    ByteReader message(content);
    const auto channel = message.number<std::uint16_t>();
    message.part(sizeof(std::uint32_t) + 2 * sizeof(std::uint64_t));  // number and times
    return Message{topics_.find(channel), content.substr(message.at())};
  }
  return std::nullopt;
}

// Takes in a schema or a channel.
void McapSource::describe(McapOp op, std::string_view content) {
  ByteReader bytes(content);
  if (op == McapOp::kSchema) {
    const auto number = bytes.number<std::uint16_t>();
    schemas_.emplace(number, TopicList::checked(bytes.sized()));
  } else if (op == McapOp::kChannel) {
    const auto number = bytes.number<std::uint16_t>();
    std::string type = schemas_[bytes.number<std::uint16_t>()];
    const std::string topic = TopicList::checked(bytes.sized()), encoding = TopicList::checked(bytes.sized());
    const bool cdr = encoding == "cdr", events = cdr && type == kEventPacket2;
    if (!cdr) type += " in " + encoding;
    topics_.add(number, {topic, type, events});
  }
}

}  // namespace saccade::client
