#include "farm/card/write_card.h"

#include <algorithm>
#include <exception>
#include <filesystem>

#include "farm/card/croissant.h"
#include "farm/card/licences.h"
#include "farm/card/sample_grid.h"
#include "farm/dataset/json_file.h"
#include "farm/recipe/recipe_reader.h"

namespace saccade::farm {
namespace {

namespace fs = std::filesystem;

// Returns the caption; empty: there is no picture.
std::string drawSamples(const DataSet& set, const std::vector<v1::DataSetSequence>& sequences,
                        const std::function<void(const std::string&)>& tell) {
  std::vector<SamplePicture> samples;
  for (const v1::DataSetSequence& sequence : sequences) {
    try {
      samples.push_back(readSample(set, sequence));
    } catch (const std::exception& fault) {
      tell("no picture of sequence " + set.sequenceName(sequence.number()) + ": " + fault.what());
    }
  }
  const fs::path folder = set.folder() / "card";
  if (samples.empty()) return fs::remove(folder / "sequences.png"), "";
  fs::create_directories(folder);
  client::writePng(folder / "sequences.png", drawGrid(set, samples));
  const bool depth = std::ranges::any_of(samples, [](const auto& sample) { return bool(sample.depth); });
  return std::string(
             "Above are the events in the middle of some sequences: red is ON, blue is OFF, and older "
             "ones are paler.") +
         (depth ? " Below are the distances then: white is near, black is far." : "");
}

}  // namespace

CardResult writeCard(const CardOptions& options, const std::function<void(const std::string&)>& tell,
                     const std::function<void(std::uint64_t)>& step) {
  const DataSet set(options.folder);
  const Recipe recipe = readRecipe(set.recipeFolder() / kRecipeFile);
  const Statistics found = statisticsOf(set, recipe, step);
  CardFacts facts{.set = set,
                  .recipe = recipe,
                  .found = found,
                  .url = options.url,
                  .licence = options.licence,
                  .creator = options.creator,
                  .published = options.published};
  CardResult result{.sequences = found.all.sequences,
                    .unfinished = set.plan().shards() - found.shards,
                    .unknown_licences = {},
                    .lacking = {}};
  for (const auto& [scene, count] : found.scenes) {
    facts.licences[scene] = licenceOf(options.scenes, scene);
    if (facts.licences[scene].empty()) result.unknown_licences.push_back(scene);
  }
  facts.pictures = drawSamples(set, found.samples, tell);
  writeText(set.folder() / "README.md", pageOf(facts));
  writeText(set.folder() / "croissant.json", croissantOf(facts));
  result.lacking = lackingFor(facts);
  return result;
}

}  // namespace saccade::farm
