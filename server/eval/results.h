// The table behind the chart: one row for each scene, method and budget. A row that stands is not run again.
#pragma once

#include <string>
#include <vector>

#include "eval/metrics/frame_errors.h"

namespace saccade {

struct Result {
  std::string scene, method;  // method with its settings: "svgf:as_falcor=1"
  int spp = 0;
  double cpu_ms = 0, trace_ms = 0;  // per frame
  double reference_error = 0;       // of the truth's dI, relative L1
  FrameErrors errors{};
};

class ResultTable {
 public:
  // `settings` says what all rows share; a file written under other settings is refused. Throws
  // std::runtime_error.
  ResultTable(std::string path, std::string settings);

  const std::vector<Result>& rows() const { return rows_; }
  bool has(const std::string& scene, const std::string& method, int spp) const;
  void add(const Result& result);  // appended to the file at once

 private:
  void read();

  std::string path_, settings_;
  std::vector<Result> rows_;
};

}  // namespace saccade
