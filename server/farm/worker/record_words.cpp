#include "farm/worker/record_words.h"

#include <algorithm>
#include <filesystem>

#include "base/names.h"
#include "client/options/record_options.h"
#include "client/options/usage_check.h"

namespace saccade::farm {
namespace {

// Options that a farm sets itself, and those for servers.
const std::set<std::string> kOwn{"output",   "force", "preview", "control",    "secret-key", "server-key",
                                 "delivery", "clock", "codec",   "retry-time", "help"};

// "threshold" of "--threshold: 7 is outside [1e-3, 5]", and of CLI11's other forms.
std::string optionIn(const std::string& message) {
  const std::size_t at = message.find("--");
  if (at == message.npos) return message.starts_with("scene") ? "scene" : "";
  const std::size_t end = message.find_first_not_of("abcdefghijklmnopqrstuvwxyz-", at);
  return message.substr(at + 2, end == message.npos ? end : end - at - 2);
}

void checkFormat(const client::OutputOptions& output) {
  try {
    output.writer();
  } catch (const std::invalid_argument& fault) {
    throw OptionFault("output", fault.what());
  }
}

// A name of a file must lie in the folder of the recipe: it is copied from there.
void checkConfined(const std::string& word) {
  const std::filesystem::path path(valueOf(word));
  if (path.is_absolute() || std::ranges::find(path, "..") != path.end())
    throw OptionFault(optionIn(word),
                      "'" + path.string() + "' is not a path within the folder of the recipe");
}

}  // namespace

std::string valueOf(const std::string& word) {
  const std::string value = word.substr(word.find('=') + 1);
  return word.starts_with("--object=") ? value.substr(value.find('=') + 1) : value;
}

std::string optionNamed(const std::string& name) {
  static CLI::App command;
  static client::RecordOptions options;
  if (command.get_options().size() < 2) client::addRecordOptions(command, options);
  const CLI::Option* option =
      name == "scene" ? command.get_option("scene") : command.get_option_no_throw("--" + name);
  if (option && !kOwn.contains(name))
    return option->get_lnames().empty() ? name : option->get_lnames().front();
  std::vector<std::string> names;
  for (const CLI::Option* known : command.get_options())
    for (const std::string& one : known->get_lnames())
      if (!kOwn.contains(one)) names.push_back(one);
  const auto similar = client::similarName(name, names);
  throw OptionFault(name, option ? "a farm sets this option itself"
                                 : "`saccade record` has no option --" + name +
                                       (similar ? "; did you mean " + *similar + "?"
                                                : "; see `saccade record --help-all`"));
}

std::vector<client::RecordJob> jobsOf(const v1::DataSetSequence& sequence,
                                      const std::vector<std::string>& outputs, const std::string& folder) {
  for (const std::string& word : sequence.options()) checkConfined(word);
  CLI::App command("", "saccade record");
  client::RecordOptions options;
  client::addRecordOptions(command, options);
  std::vector<std::string> all(sequence.options().rbegin(),
                               sequence.options().rend());  // as CLI11 wants them
  all.insert(all.begin(), "--output=" + folder + "/" + outputs.front());
  try {
    command.parse(std::move(all));
    std::vector<client::RecordJob> jobs;
    for (const std::string& output : outputs) {
      options.recording.output.path = folder + "/" + output;
      checkFormat(options.recording.output);
      jobs.push_back(client::makeRecordJob(options));
    }
    return jobs;
  } catch (const OptionFault&) {
    throw;
  } catch (const CLI::Error& fault) {
    throw OptionFault(optionIn(fault.what()), fault.what());
  } catch (const std::invalid_argument& fault) {
    throw OptionFault(optionIn(fault.what()), fault.what());
  }
}

}  // namespace saccade::farm
