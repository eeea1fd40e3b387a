#include "farm/pack/members.h"

#include <algorithm>
#include <stdexcept>

namespace saccade::farm {
namespace {

// Nothing outside of the sequence's folder gets into a tar.
void checkWithin(const std::filesystem::path& file) {
  if (file.empty() || file.is_absolute() || std::ranges::find(file, "..") != file.end())
    throw std::runtime_error("'" + file.string() + "' is not a file of a sequence");
}

}  // namespace

std::string memberName(const DataSet& set, const v1::DataSetSequence& sequence, const std::string& file) {
  std::string name = file;
  std::ranges::replace(name, '/', '.');
  return set.sequenceName(sequence.number()) + "." + name;
}

std::vector<Member> membersOf(const DataSet& set, const v1::DataSetSequence& sequence,
                              std::size_t json_bytes) {
  std::vector<Member> members{{memberName(set, sequence, kSequenceFile), nullptr, json_bytes}};
  for (const v1::DataSetFile& file : sequence.files()) {
    checkWithin(file.name());
    members.push_back({memberName(set, sequence, file.name()), &file, file.bytes()});
  }
  std::ranges::sort(members, {}, &Member::name);
  const auto twice = std::ranges::adjacent_find(members, {}, &Member::name);
  if (twice != members.end())
    throw std::runtime_error("two files of sequence " + set.sequenceName(sequence.number()) +
                             " would be called " + twice->name);
  return members;
}

}  // namespace saccade::farm
