#include "app/config/config_sources.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <stdexcept>

#include "app/config/config_file.h"
#include "app/config/nearest_name.h"

namespace saccade {
namespace {

constexpr const char* kPrefix = "SACCADE_";
// Other programs read these variables (the command saccade, the tests), or saccaded reads them besides its
// options.
constexpr const char* kOtherVariables[] = {
    "SACCADE_CONFIG",      "SACCADE_SERVER",       "SACCADE_CLIENT_KEY", "SACCADE_SERVER_KEY",
    "SACCADE_FULL",        "SACCADE_OUT",          "SACCADE_CACHE",      "SACCADE_REFERENCE_RENDERS",
    "SACCADE_REAL_SCENES", "SACCADE_LEARNED_MODEL"};

bool isNumber(const CLI::Option& option) {
  const std::string type = option.get_type_name();
  return type.starts_with("INT") || type.starts_with("UINT") || type.starts_with("FLOAT");
}

bool isFlag(const CLI::Option& option) {
  return option.get_expected_min() == 0;
}

std::string valueOf(const CLI::Option& option) {
  const std::string value = option.count() > 0 ? option.results().front() : option.get_default_str();
  if (isFlag(option)) return value == "true" ? value : "false";
  return isNumber(option) ? value : quoteToml(value);
}

}  // namespace

std::string variableName(const std::string& key) {
  std::string name = kPrefix;
  for (const char c : key) {
    name += c == '-' ? '_' : static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  }
  return name;
}

ConfigSources::ConfigSources(CLI::App& app, const std::string& file) : app_(app) {
  for (const CLI::Option* option : options()) {
    if (option->count() > 0) origins_[option] = "flag";
  }
  applyEnvironment();
  if (!file.empty()) applyFile(file);
}

std::vector<CLI::Option*> ConfigSources::options() const {
  return app_.get_options([](const CLI::Option* option) { return option->get_configurable(); });
}

std::vector<std::string> ConfigSources::keys() const {
  std::vector<std::string> keys;
  for (const CLI::Option* option : options()) keys.push_back(option->get_single_name());
  return keys;
}

std::vector<std::string> ConfigSources::warnings() const {
  std::vector<std::string> valid(std::begin(kOtherVariables), std::end(kOtherVariables)), warnings;
  for (const std::string& key : keys()) valid.push_back(variableName(key));
  for (char** entry = environ; *entry; ++entry) {
    const std::string text = *entry, name = text.substr(0, text.find('='));
    if (!name.starts_with(kPrefix) || std::find(valid.begin(), valid.end(), name) != valid.end()) continue;
    warnings.push_back("no option is set by " + name + "; did you mean " + nearestName(name, valid) + "?");
  }
  return warnings;
}

void ConfigSources::applyEnvironment() {
  for (CLI::Option* option : options()) {
    const std::string variable = variableName(option->get_single_name());
    const char* value = std::getenv(variable.c_str());
    if (value && *value) set(*option, value, variable);
  }
}

void ConfigSources::applyFile(const std::string& file) {
  const std::vector<std::string> valid = keys();
  for (const Setting& setting : readConfigFile(file)) {
    if (std::find(valid.begin(), valid.end(), setting.key) == valid.end()) {
      throw std::runtime_error(setting.origin + ": there is no '" + setting.key + "'; did you mean '" +
                               nearestName(setting.key, valid) + "'?");
    }
    set(*app_.get_option("--" + setting.key), setting.value, setting.origin);
  }
}

void ConfigSources::set(CLI::Option& option, const std::string& value, const std::string& origin) {
  if (option.count() > 0) return;
  try {
    option.add_result(value);
    option.run_callback();
  } catch (const CLI::ParseError& fault) {
    throw std::runtime_error(origin + ": " + fault.what());
  }
  origins_[&option] = origin;
}

std::string ConfigSources::describe() const {
  std::string text;
  for (const CLI::Option* option : options()) {
    const auto origin = origins_.find(option);
    const std::string value = valueOf(*option);
    text += (value == quoteToml({}) ? "# " : "") + option->get_single_name() + " = " + value + "  # " +
            (origin == origins_.end() ? "default" : origin->second) + "\n";
  }
  return text;
}

}  // namespace saccade
