#include "stream/client_keys.h"

#include <fstream>
#include <sstream>
#include <stdexcept>

#include "log/escape.h"
#include "saccade/wire/curve_key.h"

namespace saccade {
namespace {

constexpr const char* kAdmin = "admin";
constexpr const char* kRemark = "#";

// The next word; empty at the end of the line, or where a remark begins.
std::string nextWord(std::istream& line) {
  std::string word;
  line >> word;
  if (word != kRemark) return word;
  line.setstate(std::ios::failbit);
  return {};
}

// Throws std::runtime_error with what is valid.
ListedClient readClient(std::istream& words) {
  ListedClient client{.name = nextWord(words)};
  if (client.name == kAdmin) throw std::runtime_error("the word admin comes after a name: KEY NAME admin");
  if (client.name.size() > ClientKeys::kMaxNameBytes || escapeControls(client.name) != client.name)
    throw std::runtime_error("a name is at most " + std::to_string(ClientKeys::kMaxNameBytes) +
                             " bytes of UTF-8, without control characters");
  const std::string right = nextWord(words);
  client.admin = right == kAdmin;
  if ((!right.empty() && !client.admin) || !nextWord(words).empty())
    throw std::runtime_error("after a key and a name comes the word admin, a remark '# ...', or nothing");
  return client;
}

std::map<std::string, ListedClient> readList(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error("the list of client keys " + path + " cannot be read");
  std::map<std::string, ListedClient> clients;
  std::string line;
  for (int number = 1; std::getline(file, line); ++number) {
    std::istringstream words(line);
    const std::string key = nextWord(words);
    if (key.empty()) continue;
    try {
      if (!isCurveKey(key))
        throw std::runtime_error(
            "a line begins with a public key as `saccade keygen` writes it, or with '# '");
      if (!clients.emplace(key, readClient(words)).second)
        throw std::runtime_error("the key is in the list twice");
    } catch (const std::runtime_error& fault) {
      throw std::runtime_error(path + ":" + std::to_string(number) + ": " + fault.what());
    }
  }
  if (file.bad())
    throw std::runtime_error("the list of client keys " + path + " cannot be read");  // a folder
  return clients;
}

}  // namespace

ClientKeys::ClientKeys(const std::string& path) : path_(path) {
  reload();
}

void ClientKeys::reload() {
  auto clients = readList(path_);
  std::lock_guard lock(mutex_);
  CountsByName counts;
  for (const auto& [key, client] : clients) {
    if (client.name.empty() || counts.contains(client.name)) continue;
    const auto former = counts_.find(client.name);
    counts[client.name] = former == counts_.end() ? std::make_shared<ClientCounts>() : former->second;
  }
  clients_ = std::move(clients);
  counts_ = std::move(counts);
}

bool ClientKeys::allow(const std::string& key) const {
  std::lock_guard lock(mutex_);
  return clients_.contains(key);
}

ListedClient ClientKeys::find(const std::string& key) const {
  std::lock_guard lock(mutex_);
  const auto found = clients_.find(key);
  return found == clients_.end() ? ListedClient{} : found->second;
}

std::size_t ClientKeys::size() const {
  std::lock_guard lock(mutex_);
  return clients_.size();
}

std::shared_ptr<ClientCounts> ClientKeys::countsOf(const std::string& key) const {
  const std::string name = find(key).name;
  std::lock_guard lock(mutex_);
  const auto found = counts_.find(name);
  return found == counts_.end() ? nullptr : found->second;
}

ClientKeys::CountsByName ClientKeys::counts() const {
  std::lock_guard lock(mutex_);
  return counts_;
}

}  // namespace saccade
