// Sets each option from the first source that has it: flags, environment (SACCADE_...), one file, default.
//
// CLI11's own configuration file beats the environment, ignores unknown keys and does not tell where a value
// came from.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

namespace saccade {

class ConfigSources {
 public:
  // Call it after `app` has parsed its flags; keeps a reference to it. Sets the configurable options that no
  // flag has set from the environment, then from `file`; empty: none. Throws std::runtime_error naming the
  // variable, or file and line, and what is valid.
  ConfigSources(CLI::App& app, const std::string& file);

  // A file that sets every option as it is now, each with its origin. Empty ones are commented out.
  std::string describe() const;

  // One line for each variable SACCADE_... of the environment that no program of the project reads.
  std::vector<std::string> warnings() const;

 private:
  std::vector<CLI::Option*> options() const;
  std::vector<std::string> keys() const;  // the options' names, such as "log-level"
  void applyEnvironment();
  void applyFile(const std::string& file);
  void set(CLI::Option& option, const std::string& value, const std::string& origin);

  CLI::App& app_;
  std::map<const CLI::Option*, std::string> origins_;  // of what is not a default
};

// The environment's name of an option: SACCADE_LOG_LEVEL of "log-level".
std::string variableName(const std::string& key);

}  // namespace saccade
