#include "mock/server_process.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <stdexcept>

namespace saccade {
namespace {

std::vector<std::string> command(const std::vector<std::string>& flags,
                                 const std::vector<std::string>& before) {
  std::vector<std::string> words = before;
  words.push_back(SACCADED);
  words.insert(words.end(), flags.begin(), flags.end());
  const std::vector<std::pair<std::string, std::string>> defaults{{"--control", "tcp://127.0.0.1:*"},
                                                                  {"--data", "tcp://127.0.0.1:*"},
                                                                  {"--broadcast", "tcp://127.0.0.1:*"},
                                                                  {"--http", "http://127.0.0.1:0"},
                                                                  {"--threads", "1"},
                                                                  {"--limit-cpu", "0"}};
  for (const auto& [flag, value] : defaults) {
    if (std::find(flags.begin(), flags.end(), flag) == flags.end()) words.insert(words.end(), {flag, value});
  }
  return words;
}

int countEntries(const std::string& folder) {
  const std::filesystem::directory_iterator entries(folder);
  return static_cast<int>(std::distance(begin(entries), end(entries)));
}

}  // namespace

ServerProcess::ServerProcess(const std::vector<std::string>& flags, const std::vector<std::string>& before)
    : process_(command(flags, before)),
      ready_(process_.lineWith("ready: ")),
      control_(endpointAfter("control")),
      data_(endpointAfter("data")),
      broadcast_(endpointAfter("broadcast")),
      http_(endpointAfter("http")) {}

std::string ServerProcess::endpointAfter(const std::string& word) {
  const auto at = ready_.find(" " + word + " ");
  if (at == std::string::npos) throw std::runtime_error("saccaded is not ready: " + process_.rest());
  const auto from = at + word.size() + 2;
  return ready_.substr(from, ready_.find_first_of(" ,", from) - from);
}

Usage ServerProcess::usage() const {
  const std::string proc = "/proc/" + std::to_string(process_.pid());
  std::ifstream statm(proc + "/statm");
  std::int64_t pages = 0, resident = 0;
  statm >> pages >> resident;
  return {kSanitized ? 0 : resident * getpagesize(), countEntries(proc + "/fd"),
          countEntries(proc + "/task")};
}

}  // namespace saccade
