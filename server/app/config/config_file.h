// The configuration file: TOML, one key for each option, named as on the command line.
#pragma once

#include <string>
#include <vector>

namespace saccade {

struct Setting {
  std::string key, value;  // the value as it would stand on the command line
  std::string origin;      // file:line
};

// The settings of a file in its order of keys. Throws std::runtime_error naming file and line.
std::vector<Setting> readConfigFile(const std::string& path);

// A text as TOML writes it: on one line, in quotes, with escapes. TOML has no form for bytes that are not
// UTF-8: they become the characters of Latin-1.
std::string quoteToml(const std::string& text);

}  // namespace saccade
