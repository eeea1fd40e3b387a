#include "farm/card/croissant.h"

#include <filesystem>
#include <map>

#include "client/recording/digest.h"
#include "farm/card/croissant_context.h"
#include "farm/card/croissant_records.h"
#include "farm/card/json_text.h"
#include "farm/card/markdown.h"
#include "farm/dataset/json_file.h"

namespace saccade::farm {
namespace {

namespace fs = std::filesystem;

using Members = std::vector<std::pair<std::string, std::string>>;

std::string mediaType(const fs::path& file) {
  static const std::map<std::string, std::string> kTypes{
      {".h5", "application/x-hdf5"}, {".csv", "text/csv"},          {".txt", "text/plain"},
      {".json", "application/json"}, {".toml", "application/toml"}, {".jsonl", "application/jsonlines"}};
  const auto type = kTypes.find(file.extension());
  return type == kTypes.end() ? "application/octet-stream" : type->second;
}

std::string fileObject(const DataSet& set, const std::string& name, const std::string& description) {
  const std::string text = readText(set.folder() / name);
  return jsonObject({{"@type", jsonText("cr:FileObject")},
                     {"@id", jsonText(name)},
                     {"name", jsonText(name)},
                     {"description", jsonText(description)},
                     {"contentUrl", jsonText(name)},
                     {"contentSize", jsonText(std::to_string(text.size()) + " B")},
                     {"encodingFormat", jsonText(mediaType(name))},
                     {"sha256", jsonText(client::sha256Of(text))}});
}

std::string fileSet(const std::string& id, const std::string& includes, const std::string& description) {
  return jsonObject({{"@type", jsonText("cr:FileSet")},
                     {"@id", jsonText(id)},
                     {"name", jsonText(id)},
                     {"description", jsonText(description)},
                     {"encodingFormat", jsonText(mediaType(includes))},
                     {"includes", jsonText(includes)}});
}

std::string distribution(const CardFacts& facts) {
  std::vector<std::string> all{
      fileObject(facts.set, kPlanFile,
                 "What the data set holds, in the JSON form of saccade.v1.DataSetPlan."),
      fileObject(facts.set, std::string("recipe/") + kRecipeFile, "The recipe that gives the same data set."),
      fileSet(kIndexId, "shards/*/index.jsonl",
              "A line for each sequence of a shard: saccade.v1.DataSetSequence, with digests of its files.")};
  for (const auto& [file, count] : facts.found.files)
    all.push_back(fileSet(file, "shards/*/*/" + file, "Events, one file for each sequence."));
  return jsonArray(all);
}

std::string licencesOf(const CardFacts& facts) {
  if (!facts.licence.empty()) return jsonText(facts.licence);
  std::vector<std::string> all;
  for (const auto& [scene, licence] : facts.licences)
    if (!licence.empty()) all.push_back(jsonText("scene " + scene + ": " + licence));
  return all.empty() ? "" : jsonArray(all);
}

std::string descriptionOf(const CardFacts& facts) {
  std::string scenes;
  for (const auto& [scene, count] : facts.found.scenes) scenes += (scenes.empty() ? "" : ", ") + scene;
  return "Events of simulated event cameras: " + countText(facts.found.all.sequences) + " sequences, " +
         countText(facts.found.all.events) + " events, " + shortText(facts.found.all.duration_s) +
         " s, rendered by Saccade " + facts.set.plan().software_version() + " from the scenes " + scenes +
         ".";
}

void addGiven(Members& members, const std::string& name, const std::string& text) {
  if (!text.empty()) members.emplace_back(name, jsonText(text));
}

}  // namespace

std::string croissantOf(const CardFacts& facts) {
  Members members{{"@context", kCroissantContext},
                  {"@type", jsonText("sc:Dataset")},
                  {"name", jsonText(facts.set.plan().name())},
                  {"description", jsonText(descriptionOf(facts))},
                  {"conformsTo", jsonText("http://mlcommons.org/croissant/1.0")},
                  {"version", jsonText("1.0.0")},
                  {"keywords", jsonArray({jsonText("event camera"), jsonText("simulation")})},
                  {"identifier", jsonText("blake2b:" + facts.found.digest)}};
  if (const std::string licences = licencesOf(facts); !licences.empty())
    members.emplace_back("license", licences);
  addGiven(members, "url", facts.url);
  addGiven(members, "datePublished", facts.published);
  if (!facts.creator.empty())
    members.emplace_back(
        "creator", jsonObject({{"@type", jsonText("sc:Organization")}, {"name", jsonText(facts.creator)}}));
  members.emplace_back("isLiveDataset", "false");
  members.emplace_back("distribution", distribution(facts));
  members.emplace_back("recordSet", croissantRecords(facts));
  return jsonObject(members) + "\n";
}

std::vector<std::string> lackingFor(const CardFacts& facts) {
  std::vector<std::string> lacking;
  if (facts.url.empty()) lacking.push_back("--url");
  if (licencesOf(facts).empty()) lacking.push_back("--licence");
  if (facts.creator.empty()) lacking.push_back("--creator");
  if (facts.published.empty()) lacking.push_back("--published");
  return lacking;
}

}  // namespace saccade::farm
