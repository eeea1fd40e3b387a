#include "stream/client_keys.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "saccade/wire/curve_key.h"

namespace saccade {
namespace {

std::set<std::string> readKeys(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("the list of client keys " + path + " cannot be read");
  std::set<std::string> keys;
  std::string line, word;
  for (int number = 1; std::getline(file, line); ++number) {
    std::istringstream words(line);
    if (!(words >> word) || word == "#") continue;
    if (!isCurveKey(word)) {
      throw std::runtime_error(
          path + ":" + std::to_string(number) +
          ": a line begins with a public key as `saccade keygen` writes it, or with '# '");
    }
    keys.insert(word);
  }
  if (file.bad())
    throw std::runtime_error("the list of client keys " + path + " cannot be read");  // a folder
  return keys;
}

}  // namespace

ClientKeys::ClientKeys(const std::string& path) : path_(path), keys_(readKeys(path)) {}

void ClientKeys::reload() {
  auto keys = readKeys(path_);
  std::lock_guard lock(mutex_);
  keys_ = std::move(keys);
}

bool ClientKeys::allow(const std::string& key) const {
  std::lock_guard lock(mutex_);
  return keys_.contains(key);
}

std::size_t ClientKeys::size() const {
  std::lock_guard lock(mutex_);
  return keys_.size();
}

}  // namespace saccade
