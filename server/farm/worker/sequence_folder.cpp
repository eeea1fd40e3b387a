#include "farm/worker/sequence_folder.h"

#include <cerrno>
#include <system_error>
#include <utility>

#include "farm/dataset/durable.h"
#include "farm/dataset/file_digest.h"
#include "farm/dataset/json_file.h"
#include "farm/worker/failures.h"

namespace saccade::farm {

namespace fs = std::filesystem;

namespace {

// Gives a folder its name, unless another folder has it. Returns whether the folder has it now.
bool takeName(const fs::path& folder, const fs::path& name) {
  std::error_code fault;
  fs::rename(folder, name, fault);
  const bool taken = fault == std::errc::directory_not_empty || fault == std::errc::file_exists;
  if (fault && !taken) throw std::system_error(fault, name.string());
  return !taken;
}

}  // namespace

SequenceFolder::SequenceFolder(const DataSet& set, const v1::DataSetSequence& sequence,
                               const std::string& worker)
    : set_(set), path_(set.partialFolder() / (set.sequenceName(sequence.number()) + "." + worker)) {
  fs::create_directories(path_);
}

SequenceFolder::~SequenceFolder() {
  std::error_code gone;
  fs::remove_all(path_, gone);
}

void SequenceFolder::publish(v1::DataSetSequence sequence,
                             const std::vector<v1::DataSetRecording>& recordings) {
  const fs::path to = set_.sequenceFolder(sequence);
  for (v1::DataSetFile& file : filesOf(path_)) *sequence.add_files() = std::move(file);
  for (const v1::DataSetRecording& recording : recordings) *sequence.add_recordings() = recording;
  writeJson(path_ + "/" + kSequenceFile, sequence);
  flushTree(path_);
  fs::create_directories(to.parent_path());
  if (!takeName(path_, to) && !fs::exists(to / kSequenceFile)) {
    fs::remove_all(to);  // a part of the sequence, as a copy that was cut leaves it
    takeName(path_, to);
  }
  flushFile(to.parent_path());
}

bool isPublished(const DataSet& set, const v1::DataSetSequence& sequence) {
  return fs::exists(set.sequenceFolder(sequence) / kSequenceFile);
}

v1::DataSetRecording summaryOf(const v1::Recording& recording, const std::string& name) {
  v1::DataSetRecording summary;
  summary.set_file(name);
  summary.set_sensor(recording.sensor());
  summary.set_width(recording.width());
  summary.set_height(recording.height());
  summary.set_begin_ns(recording.begin_ns());
  summary.set_end_ns(recording.end_ns());
  summary.set_events(recording.events());
  for (const v1::RecordedTruth& channel : recording.truth()) summary.add_truth(channel.name());
  return summary;
}

bool settleShard(const DataSet& set, std::uint32_t shard, const std::vector<v1::DataSetSequence>& planned) {
  std::string lines;
  for (const v1::DataSetSequence& sequence : planned) {
    if (isPublished(set, sequence)) {
      lines += readText(set.sequenceFolder(sequence) / kSequenceFile);
    } else if (!failedForEver(set, sequence)) {
      return false;
    }
  }
  fs::create_directories(set.shardFolder(shard));
  removeLeftTexts(set.shardFolder(shard));
  writeText(set.indexFile(shard), lines);
  return true;
}

}  // namespace saccade::farm
