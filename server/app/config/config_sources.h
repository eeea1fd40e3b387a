// Where the value of each option comes from: flags > environment (SACCADE_...) > one file > defaults. CLI11
// by itself lets its file win over the environment, passes over unknown keys and forgets where a value came
// from.
#pragma once

#include <CLI/CLI.hpp>
#include <map>
#include <string>
#include <vector>

namespace saccade {

class ConfigSources {
 public:
  // After `app`, to which a reference is kept, has parsed its flags. Sets the configurable options that no
  // flag has set from the environment, then from `file`; empty: none. Throws std::runtime_error naming the
  // variable, or file and line, and what is valid.
  ConfigSources(CLI::App& app, const std::string& file);

  // A file that sets every option as it is now, each with its origin. What is empty is commented out.
  std::string describe() const;

 private:
  std::vector<CLI::Option*> options() const;
  void applyEnvironment();
  void applyFile(const std::string& file);
  void set(CLI::Option& option, const std::string& value, const std::string& origin);

  CLI::App& app_;
  std::map<const CLI::Option*, std::string> origins_;  // of what is not a default
};

// The name in the environment of an option: SACCADE_LOG_LEVEL of "log-level".
std::string variableName(const std::string& key);

}  // namespace saccade
