#include "client/writers/mcap_file.h"

#include <zlib.h>

#include <system_error>

#include "client/writers/mcap_record.h"

namespace saccade::client {
namespace {

constexpr std::string_view kMagic("\x89MCAP0\r\n", 8);
constexpr std::string_view kLibrary = "saccade", kNoCompression = "";
constexpr std::size_t kChunkSize = 768 * 1024;  // bytes after which a chunk ends
constexpr std::uint16_t kSchemaId = 1, kChannelId = 1;
constexpr std::uint32_t kNoCrc = 0;

std::string headerRecord(const McapChannel& channel) {
  return mcapRecord(McapOp::kHeader, McapFields().sized(channel.profile).sized(kLibrary));
}

std::string schemaRecord(const McapChannel& channel) {
  McapFields fields;
  fields.number<std::uint16_t>(kSchemaId).sized(channel.schema_name);
  fields.sized(channel.schema_encoding).sized(channel.schema);
  return mcapRecord(McapOp::kSchema, fields);
}

std::string channelRecord(const McapChannel& channel) {
  McapFields fields, metadata;
  metadata.sized(channel.metadata_key).sized("");
  fields.number<std::uint16_t>(kChannelId).number<std::uint16_t>(kSchemaId).sized(channel.topic);
  fields.sized(channel.encoding).sized(metadata.bytes());
  return mcapRecord(McapOp::kChannel, fields);
}

void addTimes(McapFields& fields, const McapSpan& span) {
  fields.number<std::uint64_t>(span.begin_ns).number<std::uint64_t>(span.end_ns);
}

std::string statisticsRecord(const McapSpan& whole, std::uint32_t chunks) {
  McapFields fields, counts;
  counts.number<std::uint16_t>(kChannelId).number<std::uint64_t>(whole.messages);
  fields.number<std::uint64_t>(whole.messages);
  fields.number<std::uint16_t>(1).number<std::uint32_t>(1);  // schemas, channels
  fields.number<std::uint32_t>(0).number<std::uint32_t>(0);  // attachments, metadata
  fields.number<std::uint32_t>(chunks);
  addTimes(fields, whole);
  return mcapRecord(McapOp::kStatistics, fields.sized(counts.bytes()));
}

void extend(McapSpan& span, const McapSpan& next) {
  if (span.messages == 0) span.begin_ns = next.begin_ns;
  span.end_ns = next.end_ns;
  span.messages += next.messages;
}

std::uint32_t crcOf(std::string_view bytes) {
  return static_cast<std::uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(bytes.data()), bytes.size()));
}

}  // namespace

void appendChunkIndex(std::string& records, const McapChunk& chunk) {
  McapFields fields, indexes;
  indexes.number<std::uint16_t>(kChannelId).number<std::uint64_t>(chunk.position + chunk.size);
  addTimes(fields, chunk.span);
  fields.number<std::uint64_t>(chunk.position).number<std::uint64_t>(chunk.size);
  fields.sized(indexes.bytes()).number<std::uint64_t>(chunk.index_size).sized(kNoCompression);
  fields.number<std::uint64_t>(chunk.content_size).number<std::uint64_t>(chunk.content_size);
  appendRecord(records, McapOp::kChunkIndex, {fields.bytes()});
}

McapFile::McapFile(const std::string& path, const McapChannel& channel)
    : file_(path), schema_(schemaRecord(channel)), channel_(channelRecord(channel)) {
  file_.append(std::string(kMagic) + headerRecord(channel) + schema_ + channel_);
}

void McapFile::add(std::uint64_t time_ns, std::string_view message, std::uint64_t events) {
  appendBytes<std::uint64_t>(entries_, time_ns);
  appendBytes<std::uint64_t>(entries_, chunk_.size());
  McapFields head;
  head.number<std::uint16_t>(kChannelId).number<std::uint32_t>(sequence_++);
  head.number<std::uint64_t>(time_ns).number<std::uint64_t>(time_ns);  // of the log, and of publishing
  appendRecord(chunk_, McapOp::kMessage, {head.bytes(), message});
  extend(span_, {time_ns, time_ns, 1});
  events_ += events;
  if (chunk_.size() >= kChunkSize) writeChunk();
}

void McapFile::writeChunk() {
  McapFields head, index;
  addTimes(head, span_);
  head.number<std::uint64_t>(chunk_.size()).number<std::uint32_t>(crcOf(chunk_));
  head.sized(kNoCompression).number<std::uint64_t>(chunk_.size());
  index.number<std::uint16_t>(kChannelId).sized(entries_);
  McapChunk chunk{.span = span_, .position = file_.size(), .content_size = chunk_.size()};
  std::string records;
  appendRecord(records, McapOp::kChunk, {head.bytes(), chunk_});
  chunk.size = records.size();
  appendRecord(records, McapOp::kMessageIndex, {index.bytes()});
  chunk.index_size = records.size() - chunk.size;
  file_.appendChunk(records, events_);
  appendChunkIndex(chunk_indexes_, chunk);
  ++chunk_count_;
  extend(whole_, span_);
  span_ = {};
  events_ = 0;
  chunk_.clear(), entries_.clear();
}

void McapFile::writeSummary() {
  std::string bytes = mcapRecord(McapOp::kDataEnd, McapFields().number<std::uint32_t>(kNoCrc)), offsets;
  const std::size_t begin = bytes.size();
  const auto addGroup = [&](McapOp op, const std::string& records) {
    if (records.empty()) return;
    McapFields offset;
    offset.number<std::uint8_t>(static_cast<std::uint8_t>(op));
    offset.number<std::uint64_t>(file_.size() + bytes.size()).number<std::uint64_t>(records.size());
    appendRecord(offsets, McapOp::kSummaryOffset, {offset.bytes()});
    bytes += records;
  };
  addGroup(McapOp::kSchema, schema_);
  addGroup(McapOp::kChannel, channel_);
  addGroup(McapOp::kStatistics, statisticsRecord(whole_, chunk_count_));
  addGroup(McapOp::kChunkIndex, chunk_indexes_);
  McapFields footer;
  footer.number<std::uint64_t>(file_.size() + begin).number<std::uint64_t>(file_.size() + bytes.size());
  bytes += offsets;
  appendRecord(bytes, McapOp::kFooter, {footer.number<std::uint32_t>(kNoCrc).bytes()});
  bytes.resize(bytes.size() - sizeof(kNoCrc));  // the CRC is of the summary and of the footer before it
  appendBytes<std::uint32_t>(bytes, crcOf(std::string_view(bytes).substr(begin)));
  file_.append(bytes += kMagic);
}

void McapFile::finish() {
  if (span_.messages > 0) writeChunk();
  writeSummary();
  file_.close();
  finished_ = true;
}

McapFile::~McapFile() {
  if (finished_) return;
  try {
    writeSummary();
  } catch (const std::system_error&) {
    // The fault that kept the file from being finished is being told already.
  }
}

}  // namespace saccade::client
