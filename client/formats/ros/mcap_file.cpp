#include "client/formats/ros/mcap_file.h"

#include <algorithm>
#include <system_error>
#include <utility>

#include "client/formats/ros/mcap_record.h"

namespace saccade::client {
namespace {

constexpr std::string_view kLibrary = "saccade", kNoCompression = "";
constexpr std::size_t kChunkSize = 768 * 1024;  // bytes after which a chunk ends
constexpr std::size_t kEntryBytes = 16;         // of an index
constexpr std::uint32_t kNoCrc = 0;

std::string headerRecord(const std::string& profile) {
  return mcapRecord(McapOp::kHeader, McapFields().sized(profile).sized(kLibrary));
}

void addTimes(McapFields& fields, const McapSpan& span) {
  fields.number<std::uint64_t>(span.begin_ns).number<std::uint64_t>(span.end_ns);
}

void extend(McapSpan& span, const McapSpan& next) {
  span.begin_ns = span.messages == 0 ? next.begin_ns : std::min(span.begin_ns, next.begin_ns);
  span.end_ns = std::max(span.end_ns, next.end_ns);
  span.messages += next.messages;
}

}  // namespace

void appendChunkIndex(std::string& records, const McapChunk& chunk) {
  McapFields fields, indexes;
  for (const auto& [number, position] : chunk.indexes)
    indexes.number<std::uint16_t>(number).number<std::uint64_t>(position);
  addTimes(fields, chunk.span);
  fields.number<std::uint64_t>(chunk.position).number<std::uint64_t>(chunk.size);
  fields.sized(indexes.bytes()).number<std::uint64_t>(chunk.index_size).sized(kNoCompression);
  fields.number<std::uint64_t>(chunk.content_size).number<std::uint64_t>(chunk.content_size);
  appendRecord(records, McapOp::kChunkIndex, {fields.bytes()});
}

McapFile::McapFile(const std::string& path, const std::string& profile,
                   const std::vector<McapChannel>& channels)
    : file_(path),
      schemas_(mcapSchemas(channels)),
      channels_(mcapChannels(channels)),
      counts_(channels.size()) {
  file_.append(std::string(kMcapMagic) + headerRecord(profile) + schemas_ + channels_);
}

void McapFile::add(std::size_t channel, std::uint64_t time_ns, std::string_view message,
                   std::uint64_t events) {
  Channel& count = counts_[channel];
  appendBytes<std::uint64_t>(count.entries, time_ns);
  appendBytes<std::uint64_t>(count.entries, chunk_.size());
  McapFields head;
  head.number<std::uint16_t>(mcapNumber(channel)).number<std::uint32_t>(count.sequence++);
  head.number<std::uint64_t>(time_ns).number<std::uint64_t>(time_ns);  // of the log, and of publishing
  appendRecord(chunk_, McapOp::kMessage, {head.bytes(), message});
  extend(span_, {time_ns, time_ns, 1});
  count.events += events;
  if (chunk_.size() >= kChunkSize) writeChunk();
}

void McapFile::writeChunk() {
  McapFields head;
  addTimes(head, span_);
  head.number<std::uint64_t>(chunk_.size()).number<std::uint32_t>(mcapCrc(chunk_));
  head.sized(kNoCompression).number<std::uint64_t>(chunk_.size());
  McapChunk chunk{.span = span_, .position = file_.size(), .content_size = chunk_.size()};
  std::string records;
  appendRecord(records, McapOp::kChunk, {head.bytes(), chunk_});
  chunk.size = records.size();
  for (std::size_t i = 0; i < counts_.size(); ++i) {
    if (counts_[i].entries.empty()) continue;
    chunk.indexes.emplace_back(mcapNumber(i), chunk.position + records.size());
    McapFields index;
    index.number<std::uint16_t>(mcapNumber(i)).sized(counts_[i].entries);
    appendRecord(records, McapOp::kMessageIndex, {index.bytes()});
  }
  chunk.index_size = records.size() - chunk.size;
  file_.append(records);
  appendChunkIndex(chunk_indexes_, chunk);
  ++chunk_count_;
  extend(whole_, span_);
  for (Channel& count : counts_) {
    count.messages += count.entries.size() / kEntryBytes, count.entries.clear();
    count.kept += std::exchange(count.events, 0);
  }
  span_ = {};
  chunk_.clear();
}

std::string McapFile::statisticsRecord() const {
  McapFields fields, counts;
  for (std::size_t i = 0; i < counts_.size(); ++i)
    counts.number<std::uint16_t>(mcapNumber(i)).number<std::uint64_t>(counts_[i].messages);
  fields.number<std::uint64_t>(whole_.messages);
  fields.number<std::uint16_t>(counts_.size()).number<std::uint32_t>(counts_.size());  // schemas, channels
  fields.number<std::uint32_t>(0).number<std::uint32_t>(0);  // attachments, metadata
  fields.number<std::uint32_t>(chunk_count_);
  addTimes(fields, whole_);
  return mcapRecord(McapOp::kStatistics, fields.sized(counts.bytes()));
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
  addGroup(McapOp::kSchema, schemas_);
  addGroup(McapOp::kChannel, channels_);
  addGroup(McapOp::kStatistics, statisticsRecord());
  addGroup(McapOp::kChunkIndex, chunk_indexes_);
  McapFields footer;
  footer.number<std::uint64_t>(file_.size() + begin).number<std::uint64_t>(file_.size() + bytes.size());
  bytes += offsets;
  appendRecord(bytes, McapOp::kFooter, {footer.number<std::uint32_t>(kNoCrc).bytes()});
  bytes.resize(bytes.size() - sizeof(kNoCrc));  // the CRC is of the summary and of the footer before it
  appendBytes<std::uint32_t>(bytes, mcapCrc(std::string_view(bytes).substr(begin)));
  file_.append(bytes += kMcapMagic);
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
