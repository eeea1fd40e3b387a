#include "eval/bench/results.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <stdexcept>

namespace saccade::eval {
namespace {

constexpr int kHeaderLines = 2;  // settings and names

std::string header() {
  std::string names =
      "scene,method,spp,cpu_ms,trace_ms,small_ms,small_late_ms,px_per_frame,reference_error,reference_events";
  for (const ScoreColumn& column : kScoreColumns) names += std::string(",") + column.name;
  for (const ScoreColumn& column : kScoreColumns) names += std::string(",") + column.name + "_seed_error";
  return names;
}

// The numbers of a row, in the order of the header.
std::vector<double*> numbers(Result& r) {
  std::vector<double*> values{&r.cpu_ms,       &r.trace_ms,        &r.time.small_ms,   &r.time.small_late_ms,
                              &r.px_per_frame, &r.reference_error, &r.reference_events};
  for (const ScoreColumn& column : kScoreColumns) values.push_back(&(r.score.*column.value));
  for (const ScoreColumn& column : kScoreColumns) values.push_back(&(r.seed_error.*column.value));
  return values;
}

// The standard error of each score over runs of different seeds.
Score seedError(const std::vector<Truth>& truth, const std::vector<BenchRun>& runs, const BenchOptions& o) {
  std::vector<Score> scores;
  for (const BenchRun& run : runs) scores.push_back(scoreOf(truth, std::span(&run, 1), o.bias, o.threshold));
  const auto n = static_cast<double>(runs.size());
  Score error{};
  for (const ScoreColumn& column : kScoreColumns) {
    double mean = 0, squares = 0;
    for (const Score& score : scores) mean += score.*column.value / n;
    for (const Score& score : scores) squares += std::pow(score.*column.value - mean, 2.0);
    error.*column.value = std::sqrt(squares / (n - 1) / n);  // NaN for a single run
  }
  return error;
}

bool hasRows(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  int lines = 0;
  while (lines <= kHeaderLines && std::getline(file, line)) ++lines;
  return lines > kHeaderLines;
}

}  // namespace

ResultTable::ResultTable(std::string path, std::string settings)
    : path_(std::move(path)), settings_("# " + std::move(settings)) {
  std::filesystem::create_directories(std::filesystem::path(path_).parent_path());
  if (hasRows(path_)) read();
}

void ResultTable::read() {
  std::ifstream file(path_);
  std::string line;
  if (!std::getline(file, line) || line != settings_) {
    throw std::runtime_error(
        path_ + " was made with other settings:\n  " + line + "\nnot with\n  " + settings_ +
        "\nGive the flags of that table, name another folder with -o, or remove the file to measure anew");
  }
  if (!std::getline(file, line) || line != header()) {
    throw std::runtime_error(path_ + " has other columns than this program writes; remove it");
  }
  while (std::getline(file, line)) {
    std::istringstream fields(line);
    Result r;
    std::string number;
    std::getline(fields, r.scene, ',');
    std::getline(fields, r.method, ',');
    std::getline(fields, number, ',');
    r.spp = std::atoi(number.c_str());
    for (double* value : numbers(r)) {
      std::getline(fields, number, ',');
      char* end = nullptr;
      *value = std::strtod(number.c_str(), &end);  // reads inf and nan, as a stream does not
      if (end == number.c_str()) fields.setstate(std::ios::failbit);
    }
    if (!fields) throw std::runtime_error(path_ + ": cannot read the row \"" + line + "\"; remove it");
    rows_.push_back(r);
  }
}

const Result* ResultTable::find(const std::string& scene, const std::string& method, int spp) const {
  for (const Result& r : rows_) {
    if (r.scene == scene && r.method == method && r.spp == spp) return &r;
  }
  return nullptr;
}

void ResultTable::add(const Result& result) {
  rows_.push_back(result);
  Result& r = rows_.back();
  std::ostringstream line;
  line << r.scene << ',' << r.method << ',' << r.spp;
  for (const double* value : numbers(r)) line << ',' << *value;
  const bool begins = rows_.size() == 1;
  std::ofstream file(path_, begins ? std::ios::trunc : std::ios::app);
  if (begins) file << settings_ << '\n' << header() << '\n';
  file << line.str() << '\n';
  if (!file.flush()) throw std::runtime_error("cannot write " + path_);
}

void printTable(const ResultTable& table) {
  std::printf("%-36s %-40s %4s %8s %7s %7s %7s %7s %8s %8s %9s %9s %8s\n", "scene", "method", "spp", "CPU ms",
              "ref.err", "dI L1", "dI MAPE", "dL L1", "dL_error", "dL_share", "false", "missed", "sigma dL");
  for (const Result& r : table.rows()) {
    const Score& s = r.score;
    std::printf("%-36s %-40s %4d %8.2f %7.3f %7.3f %7.2f %7.3f %8.3f %8.3f %9.5f %9.5f %8.5f\n",
                r.scene.c_str(), r.method.c_str(), r.spp, r.cpu_ms, r.reference_error, s.dI_l1, s.dI_mape,
                s.dL_l1, s.dL_error, s.dL_share, s.false_events, s.missed_events, s.sigma_dL);
  }
}

Result measure(const Bench& truth, const Bench& bench, const std::string& name, const MethodSpec& method,
               int spp, const BenchOptions& o, ResultTable& table, const TimeBench* times) {
  if (const Result* stands = table.find(name, method.text, spp)) return *stands;
  Result r;
  r.scene = name, r.method = method.text, r.spp = spp;
  r.px_per_frame = truth.medianPxPerFrame(), r.reference_error = truth.referenceError();
  r.reference_events = ownFalseEvents(truth.truth(), o.bias, o.threshold);
  std::vector<BenchRun> runs;
  for (int seed = 1; seed <= o.repeats; ++seed) {
    runs.push_back(bench.run(method, spp, static_cast<std::uint64_t>(seed)));
    r.cpu_ms += runs.back().cpu_ms / o.repeats, r.trace_ms += runs.back().trace_ms / o.repeats;
  }
  if (times) r.time = times->run(method, spp);
  r.score = scoreOf(truth.truth(), runs, o.bias, o.threshold);
  r.seed_error = seedError(truth.truth(), runs, o);
  table.add(r);
  return r;
}

}  // namespace saccade::eval
