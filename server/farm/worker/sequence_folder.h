// The folder of a sequence: it gets its name once it is complete.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "farm/dataset/data_set.h"
#include "saccade/v1/recording.pb.h"

namespace saccade::farm {

class SequenceFolder {
 public:
  // Makes partial/NUMBER.WORKER. Throws std::system_error, as all members do.
  SequenceFolder(const DataSet& set, const v1::DataSetSequence& sequence, const std::string& worker);
  ~SequenceFolder();  // removes it, unless it has its name
  SequenceFolder(const SequenceFolder&) = delete;
  SequenceFolder& operator=(const SequenceFolder&) = delete;

  const std::string& path() const { return path_; }
  // Adds sequence.json with the digests of all files, flushes them to the disk, and gives the folder its
  // name. Where another worker has done so already, its folder stays. `recordings`: of `files`.
  void publish(v1::DataSetSequence sequence, const std::vector<v1::DataSetRecording>& recordings);

 private:
  const DataSet& set_;
  const std::string path_;
};

bool isPublished(const DataSet& set, const v1::DataSetSequence& sequence);

// The summary of a recording in the file `name`.
v1::DataSetRecording summaryOf(const v1::Recording& recording, const std::string& name);

// Once no sequence of a shard is missing, writes its index.jsonl. `planned`: of the shard, in order. Returns
// whether there is one now. A sequence that failed for ever is not missing.
bool settleShard(const DataSet& set, std::uint32_t shard, const std::vector<v1::DataSetSequence>& planned);

}  // namespace saccade::farm
