#include "farm/report/verify_sequence.h"

#include <google/protobuf/util/message_differencer.h>

#include <exception>
#include <map>
#include <stdexcept>

#include "farm/dataset/file_digest.h"
#include "farm/dataset/json_file.h"

namespace saccade::farm {
namespace {

namespace fs = std::filesystem;

// The files that a folder should have and has not shown yet, by name.
using Expected = std::map<std::string, const v1::DataSetFile*>;

bool isPlainFile(const fs::path& path) {
  return fs::symlink_status(path).type() == fs::file_type::regular;
}

bool holdsOne(const Expected& expected, const std::string& folder) {
  const auto first = expected.lower_bound(folder + "/");
  return first != expected.end() && first->first.starts_with(folder + "/");
}

void checkFile(const fs::path& path, const v1::DataSetFile& file, Findings& findings) {
  if (!isPlainFile(path)) return findings.damaged(path, "is not a plain file");
  try {
    if (const std::uint64_t bytes = fs::file_size(path); bytes != file.bytes())
      return findings.damaged(
          path, "has " + std::to_string(bytes) + " bytes instead of " + std::to_string(file.bytes()));
    if (digestOfFile(path) != file.digest()) return findings.damaged(path, "differs from its digest");
    findings.found.bytes += file.bytes();
  } catch (const std::exception& fault) {
    findings.damaged(path, std::string("cannot be read: ") + fault.what());
  }
}

void checkFiles(const fs::path& folder, const v1::DataSetSequence& sequence, Findings& findings) {
  Expected expected;
  for (const v1::DataSetFile& file : sequence.files()) expected[file.name()] = &file;
  for (auto entry = fs::recursive_directory_iterator(folder); entry != fs::recursive_directory_iterator();
       ++entry) {
    const std::string name = entry->path().lexically_relative(folder);
    const auto file = expected.find(name);
    if (file != expected.end()) {
      checkFile(entry->path(), *file->second, findings);
      expected.erase(file);
    } else if (name != kSequenceFile && !(entry->is_directory() && holdsOne(expected, name))) {
      findings.foreign(entry->path());
      entry.disable_recursion_pending();
    }
  }
  for (const auto& [name, file] : expected) findings.miss(folder / name);
}

bool isOf(v1::DataSetSequence sequence, const v1::DataSetSequence& planned) {
  sequence.clear_files();
  sequence.clear_recordings();
  return google::protobuf::util::MessageDifferencer::Equals(sequence, planned);
}

// Throws where it cannot.
v1::DataSetSequence readSequence(const fs::path& file, std::string& text) {
  if (!isPlainFile(file)) throw std::runtime_error("is not a plain file");
  text = readText(file);
  v1::DataSetSequence sequence;
  parseJson(text, file, sequence);
  return sequence;
}

}  // namespace

void verifySequence(const DataSet& set, const v1::DataSetSequence& planned,
                    const std::optional<std::string>& listed, Findings& findings) {
  const fs::path folder = set.sequenceFolder(planned), file = folder / kSequenceFile;
  const std::uint64_t faults = findings.faults();
  std::string text;
  try {
    if (fs::is_symlink(folder)) findings.damaged(folder, "is a symbolic link");
    const v1::DataSetSequence sequence = readSequence(file, text);
    if (listed && *listed != text) findings.damaged(file, "differs from its line of index.jsonl");
    if (!isOf(sequence, planned)) findings.damaged(file, "is not of this sequence of the plan");
    checkFiles(folder, sequence, findings);
  } catch (const fs::filesystem_error& fault) {
    findings.damaged(folder, "cannot be read: " + fault.code().message());
  } catch (const std::exception&) {
    findings.damaged(file, "is no description of a sequence");
  }
  if (findings.faults() == faults) ++findings.found.sequences;
}

}  // namespace saccade::farm
