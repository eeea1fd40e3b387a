#include "feed/bake_file.h"

#include <unistd.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "base/content_hash.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;

// Before the state of a Baker.
struct Head {
  std::array<char, 8> name{'s', 'a', 'c', 'b', 'a', 'k', 'e', '1'};
  std::uint64_t plan = 0, size = 0, digest = 0;  // the state's size in bytes, and its digest
};

std::uint64_t digestOf(const std::string& state) {
  ContentHash h;
  h.bytes(state.data(), state.size());
  return h.value;
}

[[noreturn]] void fail(const std::string& path, const std::string& fault) {
  throw std::runtime_error(path + ": " + fault);
}

}  // namespace

std::string bakePath(const std::string& folder, std::uint64_t plan) {
  std::array<char, 32> name;
  std::snprintf(name.data(), name.size(), "%016llx.bake", static_cast<unsigned long long>(plan));
  return (fs::path(folder) / name.data()).string();
}

std::optional<KeptBake> readBake(const std::string& path, std::uint64_t plan) {
  std::error_code fault;
  const std::uintmax_t size = fs::file_size(path, fault);
  if (fault == std::errc::no_such_file_or_directory) return {};
  if (fault) fail(path, fault.message());
  std::ifstream file(path, std::ios::binary);
  Head head, expected;
  file.read(reinterpret_cast<char*>(&head), sizeof head);
  if (!file || head.name != expected.name) fail(path, "is not a bake of this version; remove it");
  if (head.plan != plan) fail(path, "is the bake of something else; remove it");
  if (head.size != size - sizeof head) fail(path, "is damaged: its size is wrong; remove it");
  KeptBake kept{std::string(head.size, '\0'), head.digest};
  file.read(kept.state.data(), static_cast<std::streamsize>(head.size));
  if (!file || digestOf(kept.state) != head.digest) fail(path, "is damaged; remove it");
  return kept;
}

std::uint64_t writeBake(const std::string& path, std::uint64_t plan, const std::string& state) {
  const fs::path folder = fs::path(path).parent_path();
  std::error_code fault;
  if (!folder.empty()) fs::create_directories(folder, fault);
  const std::string written = path + "." + std::to_string(getpid());
  Head head;
  head.plan = plan, head.size = state.size(), head.digest = digestOf(state);
  std::ofstream file(written, std::ios::binary);
  file.write(reinterpret_cast<const char*>(&head), sizeof head);
  file.write(state.data(), static_cast<std::streamsize>(state.size()));
  file.close();
  if (file) fs::rename(written, path, fault);
  if (!file || fault) {
    std::error_code ignored;
    fs::remove(written, ignored);
    fail(path, "cannot be written");
  }
  return head.digest;
}

}  // namespace saccade
