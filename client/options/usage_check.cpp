#include "client/options/usage_check.h"

#include <cctype>
#include <set>

#include "saccade/wire/edit_distance.h"

namespace saccade::client {
namespace {

std::string unknown(const std::string& kind, const std::string& word, const std::vector<std::string>& names) {
  const auto similar = similarName(word, names);
  return "unknown " + kind + " '" + word + "'" + (similar ? "; did you mean " + *similar + "?" : "");
}

std::vector<std::string> commandNames(const CLI::App& app) {
  std::vector<std::string> names;
  for (const CLI::App* command : app.get_subcommands({})) names.push_back(command->get_name());
  return names;
}

std::vector<std::string> optionNames(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

// A word such as -1 is a value.
bool isOption(const std::string& word) {
  return word.size() > 1 && word[0] == '-' &&
         (word[1] == '-' || std::isalpha(static_cast<unsigned char>(word[1])));
}

std::string optionFault(const CLI::App& command, const std::vector<std::string>& words) {
  std::set<const CLI::Option*> given;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    if (word.empty()) return (i > 0 && isOption(words[i - 1]) ? words[i - 1] : "an argument") + " is empty";
    if (!isOption(word)) continue;
    const std::string name = word.substr(0, word.starts_with("--") ? word.find('=') : 2);
    const CLI::Option* option = command.get_option_no_throw(name);
    if (!option) return unknown("option", word.starts_with("--") ? name : word, optionNames(command));
    if (word == name + "=") return name + " is empty";
    if (option && !given.insert(option).second && option->get_expected_max() <= 1)
      return name + " is given twice";
  }
  return "";
}

}  // namespace

std::string usageFault(const CLI::App& app, const std::vector<std::string>& words) {
  if (words.empty()) return "";
  if (words[0].starts_with('-')) return optionFault(app, words);
  const auto commands =
      app.get_subcommands([&](const CLI::App* command) { return command->get_name() == words[0]; });
  if (commands.empty()) return unknown("command", words[0], commandNames(app));
  return optionFault(*commands[0], {words.begin() + 1, words.end()});
}

std::optional<std::string> similarName(const std::string& word, const std::vector<std::string>& names) {
  std::optional<std::string> best;
  std::size_t least = (word.size() + 1) / 2;
  for (const std::string& name : names) {
    const std::size_t distance = editDistance(word, name);
    if (distance < least) least = distance, best = name;
  }
  return best;
}

}  // namespace saccade::client
