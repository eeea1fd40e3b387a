// The table behind a chart or a figure: one row for each scene, method and spp. A row of the file is not
// measured again. The file is there once it has a row.
#pragma once

#include <string>
#include <vector>

#include "eval/bench/bench_options.h"
#include "eval/bench/score.h"
#include "eval/bench/time_bench.h"

namespace saccade::eval {

struct Result {
  std::string scene, method;  // method with its settings: "svgf:as_falcor=1"
  int spp = 0;
  double cpu_ms = 0, trace_ms = 0;  // per frame
  MeasuredTime time{};              // of a TimeBench; first_ms is cpu_ms
  double px_per_frame = 0;          // median motion
  double reference_error = 0;       // of the truth's dI, relative L1
  double reference_events = 0;      // that its noise makes, ownFalseEvents()
  Score score{};
  Score seed_error{};  // standard error of each score over the seeds; NaN where one seed gives no score
};

class ResultTable {
 public:
  // `settings` describes all rows. Throws std::runtime_error, also for a file of other settings.
  ResultTable(std::string path, std::string settings);

  const std::string& path() const { return path_; }
  const std::vector<Result>& rows() const { return rows_; }
  const Result* find(const std::string& scene, const std::string& method, int spp) const;  // nullptr: none
  void add(const Result& result);  // appended to the file at once

 private:
  void read();

  std::string path_, settings_;
  std::vector<Result> rows_;
};

// Prints the main columns on stdout.
void printTable(const ResultTable& table);

// Returns the row of `name`, method and spp. If `table` has none, it is made and added. Then the method runs
// on `bench` with the seeds 1 to o.repeats, and is scored against the truth of `truth`. `times`, if it is
// given, measures how its time depends on size and length.
Result measure(const Bench& truth, const Bench& bench, const std::string& name, const MethodSpec& method,
               int spp, const BenchOptions& o, ResultTable& table, const TimeBench* times = nullptr);
// Against its own truth.
inline Result measure(const Bench& bench, const std::string& name, const MethodSpec& method, int spp,
                      const BenchOptions& o, ResultTable& table, const TimeBench* times = nullptr) {
  return measure(bench, bench, name, method, spp, o, table, times);
}

}  // namespace saccade::eval
