#include "app/config/config_sources.h"

#include <algorithm>
#include <cctype>
#include <cstdlib>
#include <stdexcept>

#include "app/config/config_file.h"
#include "base/nearest_name.h"

namespace saccade {
namespace {

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
  std::string name = "SACCADE_";
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

void ConfigSources::applyEnvironment() {
  for (CLI::Option* option : options()) {
    const std::string variable = variableName(option->get_single_name());
    const char* value = std::getenv(variable.c_str());
    if (value && *value) set(*option, value, variable);
  }
}

void ConfigSources::applyFile(const std::string& file) {
  std::vector<std::string> keys;
  for (const CLI::Option* option : options()) keys.push_back(option->get_single_name());
  for (const Setting& setting : readConfigFile(file)) {
    if (std::find(keys.begin(), keys.end(), setting.key) == keys.end()) {
      throw std::runtime_error(setting.origin + ": there is no '" + setting.key + "'; did you mean '" +
                               nearestName(setting.key, keys) + "'?");
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
