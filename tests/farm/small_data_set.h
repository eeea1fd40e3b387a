// A small data set that nobody has rendered: six sequences in two shards, with events by a formula.
#pragma once

#include <filesystem>
#include <fstream>
#include <string>

#include "farm/dataset/data_set.h"
#include "farm/dataset/file_digest.h"
#include "farm/dataset/json_file.h"
#include "farm/recipe/expand.h"

namespace saccade::farm {

inline constexpr std::uint64_t kSmallSequences = 6;
inline constexpr std::uint32_t kSmallShards = 2;
inline constexpr int kSmallWidth = 8, kSmallHeight = 4;
inline constexpr double kSmallDuration_s = 0.1;

inline std::uint64_t smallEvents(std::uint64_t number) {
  return 10 * (number + 1);
}
inline std::string smallSpeed(std::uint64_t number) {
  return "0." + std::to_string(number + 1);
}
inline std::string smallSplit(std::uint64_t number) {
  return number % 3 == 2 ? "test" : "train";
}

inline constexpr const char* kSmallRecipe = R"(name = "small"
seed = 7
sequences = 6
shards = 2
splits = { train = 0.6666, test = 0.3334 }
[draw]
speed = { uniform = [0.1, 0.7] }
[record]
output = "events.csv"
scene = { each = ["cornell-box", "nowhere"] }
motion = "roam:{speed}px"
)";

// As writeText(), without waiting for the disk. Makes the folder of the file too.
inline void putText(const std::filesystem::path& file, const std::string& text) {
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << text;
}

inline v1::DataSetSequence smallSequence(std::uint64_t number) {
  v1::DataSetSequence sequence;
  sequence.set_number(number);
  sequence.set_shard(shardOf(number, kSmallSequences, kSmallShards));
  sequence.set_split(smallSplit(number));
  sequence.add_options(number % 2 == 0 ? "cornell-box" : "nowhere");
  sequence.add_options("--motion=roam:" + smallSpeed(number) + "px");
  (*sequence.mutable_draws())["speed"] = smallSpeed(number);
  return sequence;
}

inline std::string smallCsv(std::uint64_t number) {
  std::string text = "t,x,y,p\n";
  for (std::uint64_t i = 0; i < smallEvents(number); ++i)
    text += std::to_string(100 * i) + "," + std::to_string(i % kSmallWidth) + "," +
            std::to_string(number % kSmallHeight) + "," + std::to_string(i % 2) + "\n";
  return text;
}

// Makes the folder of a sequence. Returns the line of the index.
inline std::string writeSmallSequence(const DataSet& set, std::uint64_t number) {
  v1::DataSetSequence sequence = smallSequence(number);
  const std::filesystem::path folder = set.sequenceFolder(sequence);
  putText(folder / "events.csv", smallCsv(number));
  putText(folder / "events.csv.truth/depth/times.csv", "index,t_us\n");
  for (v1::DataSetFile& file : filesOf(folder)) *sequence.add_files() = file;
  v1::DataSetRecording& recording = *sequence.add_recordings();
  recording.set_file("events.csv");
  recording.set_width(kSmallWidth);
  recording.set_height(kSmallHeight);
  recording.set_end_ns(static_cast<std::int64_t>(kSmallDuration_s * 1e9));
  recording.set_events(smallEvents(number));
  const std::string line = jsonLine(sequence);
  putText(folder / kSequenceFile, line);
  return line;
}

inline DataSet makeSmallDataSet(const std::filesystem::path& folder) {
  putText(folder / "recipe" / kRecipeFile, kSmallRecipe);
  v1::DataSetPlan plan;
  plan.set_name("small");
  plan.set_sequences(kSmallSequences);
  plan.set_shards(kSmallShards);
  plan.set_recipe_digest(digestOfFolder(folder / "recipe"));
  plan.set_software_version("0.1.0");
  plan.set_instruction_set("avx2");
  plan.add_outputs("events.csv");
  for (const auto& [name, sequences] : {std::pair("train", 4), std::pair("test", 2)}) {
    v1::DataSetSplit& split = *plan.add_splits();
    split.set_name(name);
    split.set_sequences(static_cast<std::uint64_t>(sequences));
  }
  putText(folder / kPlanFile, jsonLine(plan));
  const DataSet set(folder);
  for (std::uint32_t shard = 0; shard < kSmallShards; ++shard) {
    std::string table, index;
    const std::uint64_t end = firstOf(shard + 1, kSmallSequences, kSmallShards);
    for (std::uint64_t i = firstOf(shard, kSmallSequences, kSmallShards); i < end; ++i) {
      table += jsonLine(smallSequence(i));
      index += writeSmallSequence(set, i);
    }
    putText(planTable(folder, set.shardName(shard)), table);
    putText(set.indexFile(shard), index);
  }
  return set;
}

}  // namespace saccade::farm
