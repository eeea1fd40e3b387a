// The faults that verify() has found so far.
#pragma once

#include <functional>
#include <string>

#include "farm/dataset/data_set.h"

namespace saccade::farm {

struct Verified {
  std::uint64_t sequences = 0, bytes = 0;  // that are as they should be
  std::uint64_t failed = 0;                // sequences that can never be made
  std::uint64_t damaged = 0, missing = 0, foreign = 0;
  bool whole() const { return damaged == 0 && missing == 0 && foreign == 0; }
};

class Findings {
 public:
  using Path = std::filesystem::path;

  // `tell` hears of each fault.
  Findings(const DataSet& set, const std::function<void(const std::string&)>& tell)
      : set_(set), tell_(tell) {}

  void damaged(const Path& path, const std::string& how) {
    ++found.damaged;
    tell_("damaged: " + shown(path) + " " + how);
  }
  void miss(const Path& path, const std::string& why = "") {
    ++found.missing;
    tell_("missing: " + shown(path) + (why.empty() ? "" : " (" + why + ")"));
  }
  void foreign(const Path& path) {
    ++found.foreign;
    tell_("foreign: " + shown(path));
  }
  std::uint64_t faults() const { return found.damaged + found.missing + found.foreign; }

  Verified found = {};

 private:
  std::string shown(const Path& path) const { return path.lexically_relative(set_.folder()); }

  const DataSet& set_;
  const std::function<void(const std::string&)>& tell_;
};

}  // namespace saccade::farm
