#include "farm/card/statistics.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <set>

#include "client/recording/digest.h"
#include "farm/dataset/json_file.h"
#include "farm/dataset/line_file.h"

namespace saccade::farm {
namespace {

namespace fs = std::filesystem;

constexpr double kNsPerS = 1e9;

class Counter {
 public:
  explicit Counter(const Recipe& recipe) : planned_(recipe.sequences) {
    for (const Entry& entry : recipe.draws) draws_.emplace(entry.name, isNumber(entry.draw));
    for (const auto& options : recipe.cases)
      for (const Entry& entry : options)
        if (entry.draw.kind != Draw::Kind::kFixed) options_.emplace(entry.name, isNumber(entry.draw));
  }

  void add(const v1::DataSetSequence& sequence) {
    Totals one{.sequences = 1};
    countSensors(sequence, one);
    for (const v1::DataSetFile& file : sequence.files()) one.bytes += file.bytes();
    found.events.add(static_cast<double>(one.events));
    found.duration_s.add(one.duration_s);
    found.bytes.add(static_cast<double>(one.bytes));
    addTo(found.all, one);
    addTo(found.splits[sequence.split()], one);
    ++found.scenes[optionOf(sequence, "scene")];
    countValues(sequence);
    const std::uint64_t place = sequence.number() * kSamples / planned_;
    if (place >= next_sample_) found.samples.push_back(sequence), next_sample_ = place + 1;
  }

  Statistics found = {};

 private:
  static void addTo(Totals& sum, const Totals& one) {
    sum.sequences += one.sequences, sum.events += one.events, sum.bytes += one.bytes;
    sum.duration_s += one.duration_s;
  }

  // The events of a sensor stand in each file of events that the sequence has; they count once.
  void countSensors(const v1::DataSetSequence& sequence, Totals& one) {
    std::set<std::uint32_t> seen;
    std::set<std::string> truth, files, sizes;
    for (const v1::DataSetRecording& recording : sequence.recordings()) {
      files.insert(recording.file());
      truth.insert(recording.truth().begin(), recording.truth().end());
      if (!seen.insert(recording.sensor()).second) continue;
      const double duration_s = static_cast<double>(recording.end_ns() - recording.begin_ns()) / kNsPerS;
      const double pixels = double(recording.width()) * recording.height();
      one.events += recording.events();
      one.duration_s = std::max(one.duration_s, duration_s);
      sizes.insert(std::to_string(recording.width()) + "x" + std::to_string(recording.height()));
      if (duration_s > 0 && pixels > 0)
        found.rate.add(static_cast<double>(recording.events()) / duration_s / pixels);
    }
    for (const std::string& name : truth) ++found.truth[name];
    for (const std::string& name : files) ++found.files[name];
    for (const std::string& size : sizes) ++found.sizes[size];
  }

  void countValues(const v1::DataSetSequence& sequence) {
    for (const auto& [name, number] : draws_) {
      const auto value = sequence.draws().find(name);
      if (value != sequence.draws().end()) count(name, number, value->second);
    }
    for (const auto& [name, number] : options_) count(shownName(name), number, optionOf(sequence, name));
  }

  void count(const std::string& name, bool number, const std::string& value) {
    if (!number) {
      ++found.texts[name][value];
    } else if (!value.empty()) {
      found.numbers[name].add(std::strtod(value.c_str(), nullptr));
    }
  }

  const std::uint64_t planned_;
  std::uint64_t next_sample_ = 0;                // of kSamples equal parts of the plan
  std::map<std::string, bool> draws_, options_;  // whether they are numbers
};

void addFailures(const DataSet& set, std::uint32_t shard, Statistics& found) {
  std::error_code none;
  std::set<fs::path> files;
  for (const auto& entry : fs::directory_iterator(set.failedFolder(shard), none)) files.insert(entry.path());
  for (const fs::path& file : files) {
    auto failure = readJson<v1::FailedSequence>(file);
    if (failure.retry()) continue;
    ++found.failed;
    if (found.failures.size() < kShownFailures) found.failures.push_back(std::move(failure));
  }
}

}  // namespace

bool isNumber(const Draw& draw) {
  return draw.kind == Draw::Kind::kUniform || draw.kind == Draw::Kind::kInteger ||
         draw.kind == Draw::Kind::kLogUniform || draw.kind == Draw::Kind::kNormal;
}

std::string shownName(const std::string& option) {
  return option == "scene" ? option : "--" + option;
}

std::string optionOf(const v1::DataSetSequence& sequence, const std::string& name) {
  if (name == "scene") return sequence.options().empty() ? "" : sequence.options(0);
  std::string text;
  for (const std::string& word : sequence.options()) {
    if (word == "--" + name) return "yes";
    if (word.starts_with("--" + name + "="))
      text += (text.empty() ? "" : ", ") + word.substr(name.size() + 3);
  }
  return text;
}

Statistics statisticsOf(const DataSet& set, const Recipe& recipe,
                        const std::function<void(std::uint64_t)>& step) {
  Counter counter(recipe);
  client::Digest digest;
  for (std::uint32_t shard = 0; shard < set.plan().shards(); ++shard) {
    if (!fs::exists(set.indexFile(shard))) continue;
    ++counter.found.shards;
    LineFile lines(set.indexFile(shard));
    for (std::string line; lines.next(line);) {
      v1::DataSetSequence sequence;
      parseJson(line, set.indexFile(shard), sequence);
      counter.add(sequence);
      digest.add(line + "\n");
      step(counter.found.all.sequences);
    }
    addFailures(set, shard, counter.found);
  }
  counter.found.digest = digest.hex();
  return std::move(counter.found);
}

}  // namespace saccade::farm
