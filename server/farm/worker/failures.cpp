#include "farm/worker/failures.h"

#include <filesystem>

#include "farm/dataset/json_file.h"

namespace saccade::farm {

std::optional<v1::FailedSequence> failureOf(const DataSet& set, const v1::DataSetSequence& sequence) {
  const auto file = set.failedFile(sequence);
  if (!std::filesystem::exists(file)) return std::nullopt;
  return readJson<v1::FailedSequence>(file);
}

bool failedForEver(const DataSet& set, const v1::DataSetSequence& sequence) {
  const auto failure = failureOf(set, sequence);
  return failure && !failure->retry();
}

v1::FailedSequence recordFailure(const DataSet& set, const v1::DataSetSequence& sequence,
                                 const std::string& message, bool retry) {
  v1::FailedSequence failure = failureOf(set, sequence).value_or(v1::FailedSequence{});
  failure.set_number(sequence.number());
  failure.set_shard(sequence.shard());
  failure.set_message(message);
  failure.set_retry(retry);
  failure.set_attempts(failure.attempts() + 1);
  std::filesystem::create_directories(set.failedFolder(sequence.shard()));
  writeJson(set.failedFile(sequence), failure);
  return failure;
}

v1::FailedSequence recordCrash(const DataSet& set, const v1::DataSetSequence& sequence,
                               const std::string& message) {
  const auto before = failureOf(set, sequence);
  return recordFailure(set, sequence, message, (before ? before->attempts() : 0) + 1 < kMostCrashes);
}

void forgetFailure(const DataSet& set, const v1::DataSetSequence& sequence) {
  std::filesystem::remove(set.failedFile(sequence));
}

}  // namespace saccade::farm
