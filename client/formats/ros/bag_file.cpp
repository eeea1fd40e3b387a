#include "client/formats/ros/bag_file.h"

#include <algorithm>
#include <system_error>

#include "client/formats/common/little_endian.h"

namespace saccade::client {
namespace {

constexpr std::string_view kVersion = "#ROSBAG V2.0\n";
constexpr std::size_t kBagHeaderSize = 4096;    // bytes, without the two lengths
constexpr std::size_t kChunkSize = 768 * 1024;  // bytes after which a chunk ends, as in rosbag
constexpr std::uint32_t kIndexVersion = 1;      // of records kIndex and kChunkInfo

// Padded, so that its size stays the same when the numbers are known. While `index_position` is 0, readers
// take the bag for one that was not closed.
std::string bagHeader(std::uint64_t index_position, std::uint32_t connections, std::uint32_t chunks) {
  BagFields header(BagOp::kBagHeader);
  header.number("index_pos", index_position).number("conn_count", connections).number("chunk_count", chunks);
  std::string record;
  appendRecord(record, header, std::string(kBagHeaderSize - header.bytes().size(), ' '));
  return record;
}

}  // namespace

void appendChunkInfo(std::string& records, const BagChunk& chunk) {
  BagFields header(BagOp::kChunkInfo);
  header.number("ver", kIndexVersion).number("chunk_pos", chunk.position);
  header.time("start_time", chunk.begin).time("end_time", chunk.end);
  const auto& messages = chunk.messages;
  const auto empty = std::count(messages.begin(), messages.end(), 0u);
  header.number<std::uint32_t>("count", messages.size() - static_cast<std::size_t>(empty));  // of connections
  std::string data;
  for (std::uint32_t id = 0; id < messages.size(); ++id) {
    if (messages[id] == 0) continue;
    appendBytes<std::uint32_t>(data, id);
    appendBytes<std::uint32_t>(data, messages[id]);
  }
  appendRecord(records, header, data);
}

BagFile::BagFile(const std::string& path, const std::vector<BagTopic>& topics)
    : file_(path),
      connections_(connectionRecords(topics)),
      chunk_(connections_),
      entries_(topics.size()),
      kept_(topics.size()) {
  file_.append(std::string(kVersion) + bagHeader(0, 0, 0));
  startChunk();
}

void BagFile::startChunk() {
  about_ = {.messages = std::vector<std::uint32_t>(entries_.size())};
  for (std::string& entries : entries_) entries.clear();
  events_.assign(entries_.size(), 0);
}

void BagFile::add(std::size_t topic, const RosTime& time, std::string_view message, std::uint64_t events) {
  const bool first = about_.end == RosTime{};
  about_.begin = first ? time : std::min(about_.begin, time);
  about_.end = std::max(about_.end, time);
  ++about_.messages[topic];
  appendTime(entries_[topic], time);
  appendBytes<std::uint32_t>(entries_[topic], chunk_.size());
  BagFields header(BagOp::kMessage);
  header.number("conn", static_cast<std::uint32_t>(topic)).time("time", time);
  appendRecord(chunk_, header, message);
  events_[topic] += events;
  if (chunk_.size() >= kChunkSize) writeChunk();
}

void BagFile::writeChunk() {
  BagFields header(BagOp::kChunk);
  header.text("compression", "none").number<std::uint32_t>("size", chunk_.size());
  std::string records;
  appendRecord(records, header, chunk_);
  for (std::uint32_t id = 0; id < entries_.size(); ++id) {
    if (about_.messages[id] == 0) continue;
    BagFields index(BagOp::kIndex);
    index.number("ver", kIndexVersion).number("conn", id).number("count", about_.messages[id]);
    appendRecord(records, index, entries_[id]);
  }
  about_.position = file_.size();
  file_.append(records);
  appendChunkInfo(chunk_infos_, about_);
  for (std::size_t topic = 0; topic < kept_.size(); ++topic) kept_[topic] += events_[topic];
  ++chunk_count_;
  chunk_.clear();
  startChunk();
}

void BagFile::writeIndex() {
  const std::uint64_t position = file_.size();
  file_.append(connections_ + chunk_infos_);
  file_.overwrite(kVersion.size(),
                  bagHeader(position, static_cast<std::uint32_t>(entries_.size()), chunk_count_));
}

void BagFile::finish() {
  if (about_.end != RosTime{}) writeChunk();  // stamps begin at 1 ns
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
