#include "farm/report/verify_shard.h"

#include <algorithm>
#include <charconv>
#include <exception>

#include "farm/dataset/json_file.h"
#include "farm/dataset/line_file.h"
#include "farm/report/index_walk.h"
#include "farm/report/verify_sequence.h"
#include "farm/worker/failures.h"
#include "farm/worker/sequence_folder.h"

namespace saccade::farm {
namespace {

namespace fs = std::filesystem;

class ShardVerifier {
 public:
  ShardVerifier(const DataSet& set, std::uint32_t shard, Findings& findings)
      : set_(set),
        shard_(shard),
        first_(set.first(shard)),
        end_(first_ + set.shardSize(shard)),
        table_(planTable(set.folder(), set.shardName(shard))),
        index_(set.indexFile(shard)),
        findings_(findings) {}

  void sequences(const std::function<void(const Verified&)>& step) {
    if (!fs::exists(table_)) return findings_.miss(table_);
    try {
      LineFile table(table_);
      std::uint64_t number = first_;
      for (std::string line; table.next(line); ++number) {
        v1::DataSetSequence planned;
        parseJson(line, table_, planned);
        if (planned.number() != number || number >= end_ || planned.shard() != shard_) break;
        check(planned);
        step(findings_.found);
      }
      if (number != end_) findings_.damaged(table_, "is not the table of the shard");
    } catch (const std::exception& fault) {
      findings_.damaged(table_, std::string("cannot be read: ") + fault.what());
    }
    if (!index_.sound()) findings_.damaged(set_.indexFile(shard_), "is not the list of the sequences");
  }

  void foreign() {
    names(set_.shardFolder(shard_), "");
    names(set_.failedFolder(shard_), ".json");
  }

 private:
  void check(const v1::DataSetSequence& planned) {
    try {
      sequence(planned);
    } catch (const fs::filesystem_error& fault) {
      findings_.damaged(set_.sequenceFolder(planned), "cannot be read: " + fault.code().message());
    }
  }

  void sequence(const v1::DataSetSequence& planned) {
    const std::optional<std::string> listed = index_.take(planned.number());
    if (isPublished(set_, planned)) {
      if (!listed) index_.setWrong();
      verifySequence(set_, planned, listed, findings_);
      return;
    }
    const std::optional<v1::FailedSequence> failure = failureIn(planned);
    if (failure && !failure->retry()) {
      ++findings_.found.failed;
      if (listed) index_.setWrong();
    } else {
      const fs::path folder = set_.sequenceFolder(planned);
      findings_.miss(fs::exists(folder) ? folder / kSequenceFile : folder, failure ? failure->message() : "");
    }
  }

  std::optional<v1::FailedSequence> failureIn(const v1::DataSetSequence& planned) {
    try {
      return failureOf(set_, planned);
    } catch (const std::exception&) {
      findings_.damaged(set_.failedFile(planned), "cannot be read");
      return std::nullopt;
    }
  }

  // Names what is in a folder beside things of sequences of the shard.
  void names(const fs::path& folder, const std::string& ending) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder, none)) {
      const std::string name = entry.path().filename();
      const auto number = numberOf(name.substr(0, name.size() - std::min(name.size(), ending.size())));
      const bool ours = number && *number >= first_ && *number < end_ &&
                        set_.sequenceName(*number) + ending == name &&
                        (entry.symlink_status().type() == fs::file_type::regular) == !ending.empty();
      if (!ours && entry.path() != set_.indexFile(shard_)) findings_.foreign(entry.path());
    }
  }

  const DataSet& set_;
  const std::uint32_t shard_;
  const std::uint64_t first_, end_;  // sequences
  const fs::path table_;
  IndexWalk index_;
  Findings& findings_;
};

}  // namespace

std::optional<std::uint64_t> numberOf(const std::string& name) {
  std::uint64_t number = 0;
  const char* const end = name.data() + name.size();
  const auto read = std::from_chars(name.data(), end, number);
  return read.ec == std::errc() && read.ptr == end ? std::optional(number) : std::nullopt;
}

void verifyShard(const DataSet& set, std::uint32_t shard, Findings& findings,
                 const std::function<void(const Verified&)>& step) {
  ShardVerifier verifier(set, shard, findings);
  verifier.sequences(step);
  verifier.foreign();
}

}  // namespace saccade::farm
