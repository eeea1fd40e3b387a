#include "farm/plan/pinned_options.h"

#include <algorithm>
#include <array>

#include "farm/plan/temporary_folder.h"
#include "farm/recipe/draw.h"
#include "farm/worker/record_words.h"

namespace saccade::farm {
namespace {

constexpr std::array<const char*, 3> kBudgets{"--budget-ms=", "--max-false-rate=", "--max-event-change="};
// Options that the answer to a budget replaces.
constexpr std::array<const char*, 5> kAnswers{"--method=", "--spp=", "--set=", "--bounces=", "--disable="};

bool beginsWithOneOf(const std::string& word, const auto& beginnings) {
  return std::ranges::any_of(beginnings, [&](const char* begin) { return word.starts_with(begin); });
}

void addAnswer(const v1::OpenStream& resolved, v1::DataSetSequence& sequence) {
  sequence.add_options("--method=" + resolved.method().name());
  sequence.add_options("--spp=" + std::to_string(resolved.method().spp()));
  std::vector<std::string> params;
  for (const auto& [name, value] : resolved.method().params())
    params.push_back(name + "=" + exactText(value));
  std::ranges::sort(params);
  for (const std::string& param : params) sequence.add_options("--set=" + param);
  sequence.add_options("--bounces=" + std::to_string(resolved.quality().bounces()));
  for (const std::string& feature : resolved.quality().disabled_features())
    sequence.add_options("--disable=" + feature);
}

}  // namespace

void pinOptions(const SequenceRenderer& renderer, const std::vector<std::string>& outputs,
                v1::DataSetSequence& sequence) {
  auto& options = *sequence.mutable_options();
  if (std::ranges::none_of(options, [](const std::string& word) { return beginsWithOneOf(word, kBudgets); }))
    return;
  const std::vector<std::string> words(options.begin(), options.end());
  const TemporaryFolder nowhere;
  const v1::OpenStream resolved =
      renderer.plan(jobsOf(sequence, outputs, nowhere.path()).front().request).resolved.request;
  options.Clear();
  for (const std::string& word : words)
    if (!beginsWithOneOf(word, kBudgets) && !beginsWithOneOf(word, kAnswers)) sequence.add_options(word);
  addAnswer(resolved, sequence);
}

}  // namespace saccade::farm
