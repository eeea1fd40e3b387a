// The sources of the configuration: flags, then the environment, each one in a line, an empty line, the file.
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdlib>
#include <optional>

#include "app/config/config.h"
#include "app/config/config_sources.h"
#include "fuzz/fuzz_target.h"
#include "scene/files/text.h"
#include "scene/scratch.h"

namespace saccade {
namespace {

// The variables of one input.
class Environment {
 public:
  void set(const std::string& name, const std::string& value) {
    if (!name.starts_with("SACCADE_")) return;
    names_.push_back(name);
    setenv(name.c_str(), value.c_str(), 1);
  }
  ~Environment() {
    for (const std::string& name : names_) unsetenv(name.c_str());
  }

 private:
  std::vector<std::string> names_;
};

struct Sources {
  Config config;
  std::string described;
};

// As a server reads them that is started so.
Sources readSources(std::vector<std::string> flags, const std::string& file) {
  Sources sources;
  CLI::App app;
  addOptions(app, sources.config);
  std::reverse(flags.begin(), flags.end());  // CLI11 takes them from the back
  app.parse(std::move(flags));
  sources.described = ConfigSources(app, file).describe();
  return sources;
}

// Only the file is bound to be UTF-8.
bool isAscii(std::string_view text) {
  return std::none_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) > 127; });
}

// A description gives the same description again.
void checkDescribed(const Sources& sources, const Scratch& files) {
  const Sources again = readSources({}, files.write("again.toml", sources.described));
  SACCADE_CHECK(again.config == sources.config);
}

bool read(std::string_view bytes) {
  static const Scratch files;
  const std::string_view all = bytes;
  std::vector<std::string> flags;
  std::optional<Environment> environment(std::in_place);
  while (!bytes.empty()) {
    const std::string line(takeLine(bytes));
    if (line.empty()) break;
    const auto equals = line.find('=');
    if (line[0] == '-' || equals == std::string::npos) {
      flags.push_back(line);
    } else {
      environment->set(line.substr(0, equals), line.substr(equals + 1));
    }
  }
  const bool ascii = isAscii({all.begin(), bytes.begin()});
  const std::string file = files.write("saccaded.toml", std::string(bytes));
  return accepts<std::runtime_error>([&] {
    const Sources sources = readSources(flags, file);
    environment.reset();
    if (ascii) checkDescribed(sources, files);
  });
}

}  // namespace

const FuzzTarget& fuzzTarget() {
  static const FuzzTarget target{{"--threads\n2\n--insecure\nSACCADE_LOG_LEVEL=debug\n\ndata = "
                                  "\"tcp://[::1]:7\" # free\ndrain-time = 2.5\n",
                                  "--http=off\nSACCADE_SCENES=.\n\nsecret-key = 'a'\nclient-keys = "
                                  "\"\"\"b\n\\u00e9\"\"\"\ninsecure = false\n"
                                  "threads = 0x10\nlog-format = 'json'\n"},
                                 {"--threads",
                                  "--data",
                                  "--insecure",
                                  "--scenes",
                                  "--",
                                  "=",
                                  "\n",
                                  "\n\n",
                                  "'",
                                  "\"",
                                  "\"\"\"",
                                  "\\",
                                  "SACCADE_THREADS=",
                                  "SACCADE_INSECURE=",
                                  "SACCADE_DRAIN_TIME=",
                                  "accuracy",
                                  "log-level",
                                  "simplification",
                                  "[a]",
                                  "{}",
                                  "nan",
                                  "inf",
                                  "-1",
                                  "1e400",
                                  "1_0",
                                  "0b1",
                                  "1979-05-27T07:32:00Z",
                                  "true",
                                  "false",
                                  "\xff",
                                  "#"},
                                 read,
                                 nullptr,
                                 2000};
  return target;
}

}  // namespace saccade
