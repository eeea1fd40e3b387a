// A data set that has no more than a plan, for tests of what engines get.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "client/scratch_folder.h"
#include "farm/dataset/data_set.h"
#include "farm/dataset/json_file.h"

namespace saccade::farm {

class PlannedSet {
 public:
  explicit PlannedSet(std::uint32_t shards, const std::string& folder = "set",
                      const std::string& name = "indoor")
      : path_(scratch_.at(folder)) {
    v1::DataSetPlan plan;
    plan.set_name(name);
    plan.set_sequences(10 * shards);
    plan.set_shards(shards);
    plan.set_recipe_digest("0123456789abcdef");
    std::filesystem::create_directories(path_);
    std::ofstream(std::filesystem::path(path_) / kPlanFile) << jsonLine(plan);
  }
  const std::string& path() const { return path_; }
  DataSet set() const { return DataSet(path_); }

 private:
  ScratchFolder scratch_;
  const std::string path_;
};

}  // namespace saccade::farm
