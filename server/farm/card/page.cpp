#include "farm/card/page.h"

#include "farm/card/markdown.h"
#include "farm/card/option_tables.h"

namespace saccade::farm {
namespace {

std::string megabytes(std::uint64_t bytes) {
  return shortText(static_cast<double>(bytes) / 1e6) + " MB";
}

std::vector<std::string> rowOf(const std::string& name, const Totals& totals) {
  return {name, countText(totals.sequences), countText(totals.events), shortText(totals.duration_s) + " s",
          megabytes(totals.bytes)};
}

std::string listOf(const std::map<std::string, std::uint64_t>& counts) {
  std::string text;
  for (const auto& [name, count] : counts)
    text += (text.empty() ? "" : ", ") + codeOf(name) + " (" + countText(count) + ")";
  return text.empty() ? "none" : text;
}

std::string contents(const CardFacts& facts) {
  const Statistics& found = facts.found;
  std::vector<std::vector<std::string>> rows;
  for (const v1::DataSetSplit& split : facts.set.plan().splits()) {
    const auto at = found.splits.find(split.name());
    rows.push_back(rowOf(codeOf(split.name()), at == found.splits.end() ? Totals{} : at->second));
  }
  rows.push_back(rowOf("all", found.all));
  std::string text =
      "## What is in it\n\n" + tableOf({"split", "sequences", "events", "duration", "size"}, rows);
  text += "In brackets: how many sequences have it.\n\n";
  text += "- Scenes: " + listOf(found.scenes) + "\n";
  text += "- Sizes of sensors, pixels: " + listOf(found.sizes) + "\n";
  text += "- Truth beside the events: " + listOf(found.truth) + "\n";
  text += "- Files of events: " + listOf(found.files) + "\n\n";
  if (!facts.pictures.empty()) text += "![sequences](card/sequences.png)\n\n" + facts.pictures + "\n\n";
  return text;
}

std::string whatIsMissing(const CardFacts& facts) {
  const v1::DataSetPlan& plan = facts.set.plan();
  const Statistics& found = facts.found;
  std::string text;
  if (found.shards < plan.shards())
    text += "**The data set is not complete.** This page tells of " + countText(found.shards) + " of its " +
            countText(plan.shards()) + " shards.\n\n";
  if (found.failed == 0) return text;
  text += "## What could not be made\n\n" + countText(found.failed) +
          " sequences of the plan can never be made, and are left out.\n\n";
  std::vector<std::vector<std::string>> rows;
  for (const v1::FailedSequence& failure : found.failures)
    rows.push_back({std::to_string(failure.number()), plainOf(failure.message())});
  text += tableOf({"sequence", "why"}, rows);
  return found.failures.size() < found.failed ? text + "`failed/` tells of all.\n\n" : text;
}

std::string licences(const CardFacts& facts) {
  std::string text = "## Licences\n\n";
  if (!facts.licence.empty()) text += "The data set: " + plainOf(facts.licence) + "\n\n";
  text += "The events are computed from scenes that others may have made:\n\n";
  std::vector<std::vector<std::string>> rows;
  for (const auto& [scene, licence] : facts.licences)
    rows.push_back({codeOf(scene), licence.empty() ? "**not known**" : plainOf(licence)});
  return text + tableOf({"scene", "licence"}, rows);
}

std::string howToMake(const CardFacts& facts) {
  const v1::DataSetPlan& plan = facts.set.plan();
  return "## How to make it again\n\n"
         "Saccade " +
         plan.software_version() +
         " gives the same bytes on every machine with these vector instructions, with the same scenes:\n\n"
         "    saccade-farm plan recipe/recipe.toml -o again --instructions " +
         plan.instruction_set() +
         "\n"
         "    saccade-farm run again\n"
         "    saccade-farm verify again\n\n" +
         tableOf({"", ""}, {{"software", "Saccade " + plan.software_version()},
                            {"vector instructions", codeOf(plan.instruction_set())},
                            {"seed of the recipe", std::to_string(plan.seed())},
                            {"digest of the folder `recipe`", codeOf(plan.recipe_digest())},
                            {"digest of all `index.jsonl`", codeOf(facts.found.digest)}}) +
         "Digests are BLAKE2b of 32 bytes. The files `index.jsonl` have that of each file of a sequence. The "
         "last digest above is over these files in the order of the shards.\n\n";
}

std::string howToRead(const CardFacts& facts) {
  return "## How to read it\n\n"
         "    import saccade\n\n"
         "    data = saccade.Dataset(\"" +
         facts.recipe.name + "\", split=\"" + facts.recipe.splits.front().first +
         "\", window_s=0.05)\n"
         "    window = data[0]\n"
         "    window.events.t, window.events.x, window.events.y, window.events.p\n\n"
         "`plan/SHARD.jsonl` lists what was planned. A sequence is a folder `shards/SHARD/NUMBER` with its "
         "files of events. `sequence.json` in it tells what was drawn, and `shards/SHARD/index.jsonl` has "
         "these of a whole shard. `croissant.json` describes the data set to programs.\n";
}

}  // namespace

std::string pageOf(const CardFacts& facts) {
  return "# " + plainOf(facts.set.plan().name()) +
         "\n\nEvents of simulated event cameras: " + countText(facts.found.all.sequences) +
         " sequences, which Saccade has rendered.\n\n" + contents(facts) + whatIsMissing(facts) +
         "## Statistics\n\n" + drawnTables(facts.found) +
         "A histogram goes from the least to the greatest value.\n\n## Options\n\n" +
         optionTables(facts.recipe) + licences(facts) + howToMake(facts) + howToRead(facts);
}

}  // namespace saccade::farm
