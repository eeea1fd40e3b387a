// workers/NAME.json: how far a worker is. A lock on it tells those that run from those that have died.
#pragma once

#include <string>
#include <vector>

#include "farm/dataset/data_set.h"

namespace saccade::farm {

// The file of this program. Children that are forked hold its lock, too.
class WorkerFile {
 public:
  explicit WorkerFile(const DataSet& set);  // throws std::system_error
  ~WorkerFile();                            // removes it, in the process that has made it
  WorkerFile(const WorkerFile&) = delete;
  WorkerFile& operator=(const WorkerFile&) = delete;

  const std::string& name() const { return name_; }  // "render7-4711-1a2b3c"
  // Writes the state, with the time of now.
  void tell(v1::FarmWorker state);

 private:
  const std::string name_, path_;
  const int owner_;  // process
  int file_ = -1;
  v1::FarmWorker first_;
};

// The workers that run now. Removes the files and the partial folders of those that have died.
std::vector<v1::FarmWorker> liveWorkers(const DataSet& set);
void removeLeftovers(const DataSet& set);

}  // namespace saccade::farm
