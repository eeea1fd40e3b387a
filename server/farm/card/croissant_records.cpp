#include "farm/card/croissant_records.h"

#include <vector>

#include "farm/card/json_text.h"

namespace saccade::farm {
namespace {

using Members = std::vector<std::pair<std::string, std::string>>;

struct Field {
  std::string name, type, description;
  std::string column;
  std::string path = {};  // within the column
  bool repeated = false;
  bool split = false;
};

std::string reference(const std::string& id) {
  return jsonObject({{"@id", jsonText(id)}});
}

std::string sourceOf(const Field& field) {
  Members members{{"fileSet", reference(kIndexId)},
                  {"extract", jsonObject({{"column", jsonText(field.column)}})}};
  if (!field.path.empty())
    members.emplace_back("transform", jsonObject({{"jsonPath", jsonText(field.path)}}));
  return jsonObject(members);
}

std::string fieldOf(const Field& field) {
  const std::string id = "sequences/" + field.name;
  Members members{{"@type", jsonText("cr:Field")},
                  {"@id", jsonText(id)},
                  {"name", jsonText(field.name)},
                  {"description", jsonText(field.description)},
                  {"dataType", jsonText(field.type)}};
  if (field.repeated) members.emplace_back("repeated", "true");
  members.emplace_back("source", sourceOf(field));
  if (field.split) members.emplace_back("references", jsonObject({{"field", reference("splits/name")}}));
  return jsonObject(members);
}

std::vector<std::string> fieldsOf(const Recipe& recipe) {
  std::vector<std::string> fields;
  for (const Field& field : std::initializer_list<Field>{
           {"number", "sc:Integer", "From 0 on.", "number"},
           {"shard", "sc:Integer", "The number of its shard.", "shard"},
           {.name = "split",
           .type = "sc:Text",
           .description = "The split that it is in.",
           .column = "split",
           .split = true},
           {"options", "sc:Text", "The words behind `saccade record` that give it.", "options", "", true},
           {"width", "sc:Integer", "Pixels of each recording.", "recordings", "$.width", true},
           {"height", "sc:Integer", "Pixels of each recording.", "recordings", "$.height", true},
           {"events", "sc:Integer", "Events of each recording.", "recordings", "$.events", true},
           {"files", "sc:Text", "Names of its files.", "files", "$.name", true},
           {"digests", "sc:Text", "BLAKE2b of 32 bytes of each file.", "files", "$.digest", true}})
    fields.push_back(fieldOf(field));
  for (const Entry& entry : recipe.draws)
    fields.push_back(fieldOf({"draws/" + entry.name, isNumber(entry.draw) ? "sc:Float" : "sc:Text",
                              "What was drawn for it.", "draws", "$['" + entry.name + "']"}));
  return fields;
}

// The purpose of a split, as far as its name tells it.
std::string kindOf(const std::string& split) {
  for (const auto& [begin, kind] :
       {std::pair("train", "cr:TrainingSplit"), std::pair("val", "cr:ValidationSplit"),
        std::pair("test", "cr:TestSplit")})
    if (split.starts_with(begin)) return jsonText(kind);
  return "null";
}

std::string splitsOf(const v1::DataSetPlan& plan) {
  std::vector<std::string> names;
  for (const v1::DataSetSplit& split : plan.splits())
    names.push_back(
        jsonObject({{"splits/name", jsonText(split.name())}, {"splits/url", kindOf(split.name())}}));
  const auto field = [](const std::string& name, const std::string& type) {
    return jsonObject({{"@type", jsonText("cr:Field")},
                       {"@id", jsonText("splits/" + name)},
                       {"name", jsonText(name)},
                       {"dataType", jsonText(type)}});
  };
  return jsonObject({{"@type", jsonText("cr:RecordSet")},
                     {"@id", jsonText("splits")},
                     {"name", jsonText("splits")},
                     {"dataType", jsonText("cr:Split")},
                     {"key", reference("splits/name")},
                     {"field", jsonArray({field("name", "sc:Text"), field("url", "sc:URL")})},
                     {"data", jsonArray(names)}});
}

}  // namespace

std::string croissantRecords(const CardFacts& facts) {
  const std::string sequences = jsonObject({{"@type", jsonText("cr:RecordSet")},
                                            {"@id", jsonText("sequences")},
                                            {"name", jsonText("sequences")},
                                            {"description", jsonText("One record for each sequence.")},
                                            {"key", reference("sequences/number")},
                                            {"field", jsonArray(fieldsOf(facts.recipe))}});
  return jsonArray({splitsOf(facts.set.plan()), sequences});
}

}  // namespace saccade::farm
