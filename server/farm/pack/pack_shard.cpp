#include "farm/pack/pack_shard.h"

#include <cerrno>
#include <cstdio>
#include <map>
#include <memory>
#include <system_error>

#include "client/recording/digest.h"
#include "farm/dataset/json_file.h"
#include "farm/dataset/line_file.h"
#include "farm/pack/members.h"
#include "farm/pack/new_tar.h"

namespace saccade::farm {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kChunk = 1 << 18;

void eachSequence(const DataSet& set, std::uint32_t shard,
                  const std::function<bool(const v1::DataSetSequence&, const std::string&)>& see) {
  LineFile lines(set.indexFile(shard));
  for (std::string line; lines.next(line);) {
    v1::DataSetSequence sequence;
    parseJson(line, set.indexFile(shard), sequence);
    if (!see(sequence, line + "\n")) return;
  }
}

// The bytes that the tar of each split will have.
std::map<std::string, std::uint64_t> sizesOf(const DataSet& set, std::uint32_t shard) {
  std::map<std::string, std::uint64_t> sizes;
  for (const v1::DataSetSplit& split : set.plan().splits())
    if (split.sequences() > 0) sizes[split.name()] = kTarEnd;
  eachSequence(set, shard, [&](const v1::DataSetSequence& sequence, const std::string& json) {
    std::uint64_t& size = sizes.try_emplace(sequence.split(), kTarEnd).first->second;
    for (const Member& member : membersOf(set, sequence, json.size()))
      size += tarSpace(member.name, member.bytes);
    return true;
  });
  return sizes;
}

void checkFile(bool sound, const DataSet& set, const fs::path& path, const std::string& fault) {
  if (!sound) throw DamagedFile(path.lexically_relative(set.folder()).string() + " " + fault);
}

void copyFile(const DataSet& set, const fs::path& path, const v1::DataSetFile& file, TarWriter& writer) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> input(std::fopen(path.c_str(), "rb"), std::fclose);
  checkFile(bool(input), set, path, input ? "" : std::generic_category().message(errno));
  std::string chunk(kChunk, '\0');
  client::Digest digest;
  std::uint64_t left = file.bytes();
  while (const std::size_t read = std::fread(chunk.data(), 1, chunk.size(), input.get())) {
    checkFile(read <= left, set, path, "is longer than it was");
    left -= read;
    digest.add({chunk.data(), read});
    writer.append({chunk.data(), read});
  }
  checkFile(!std::ferror(input.get()), set, path, "cannot be read");
  checkFile(left == 0, set, path, "is shorter than it was");
  checkFile(digest.hex() == file.digest(), set, path, "differs from its digest");
}

void addSequence(const DataSet& set, const v1::DataSetSequence& sequence, const std::string& json,
                 TarWriter& writer) {
  for (const Member& member : membersOf(set, sequence, json.size())) {
    writer.begin(member.name, member.bytes);
    if (member.file) {
      copyFile(set, set.sequenceFolder(sequence) / member.file->name(), *member.file, writer);
    } else {
      writer.append(json);
    }
    writer.end();
  }
}

using Tars = std::map<std::string, NewTar>;  // by split

// Begins those that are missing.
void begin(const DataSet& set, std::uint32_t shard, const std::map<std::string, std::uint64_t>& sizes,
           Tars& tars, PackCounts& counts) {
  for (const auto& [split, size] : sizes) {
    const fs::path path = tarFile(set, shard, split);
    std::error_code none;
    if (fs::file_size(path, none) == size && !none) {
      ++counts.found;
    } else {
      tars.try_emplace(split, path);
    }
  }
}

}  // namespace

fs::path tarFile(const DataSet& set, std::uint32_t shard, const std::string& split) {
  return set.folder() / "webdataset" / (split + "-" + set.shardName(shard) + ".tar");
}

void packShard(const DataSet& set, std::uint32_t shard, const std::function<bool()>& stop,
               const std::function<void(const PackCounts&)>& step, PackCounts& counts) {
  const std::map<std::string, std::uint64_t> sizes = sizesOf(set, shard);
  Tars tars;
  begin(set, shard, sizes, tars, counts);
  if (tars.empty()) return;
  PackCounts now = counts;
  eachSequence(set, shard, [&](const v1::DataSetSequence& sequence, const std::string& json) {
    const auto tar = tars.find(sequence.split());
    if (tar == tars.end()) return true;
    addSequence(set, sequence, json, tar->second.writer());
    ++now.sequences;
    step(now);
    counts.stopped = stop();
    return !counts.stopped;
  });
  if (counts.stopped) return;
  for (auto& [split, tar] : tars) {
    tar.publish();
    ++now.written;
    now.bytes += sizes.at(split);
  }
  counts = now;
}

}  // namespace saccade::farm
