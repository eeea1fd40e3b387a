#include "feed/bake_file.h"

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <stdexcept>
#include <system_error>

#include "base/content_hash.h"
#include "feed/temporary_file.h"

namespace saccade {
namespace {

namespace fs = std::filesystem;

constexpr const char *kExtension = ".bake", *kAside = ".damaged";

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

std::optional<KeptBake> readBake(const std::string& path, std::uint64_t plan, std::uint64_t most_bytes) {
  std::error_code fault;
  const fs::file_status status = fs::status(path, fault);
  if (status.type() == fs::file_type::not_found) return {};
  if (!fs::is_regular_file(status)) fail(path, "is not a file");  // opening a pipe would wait for its writer
  const std::uintmax_t size = fs::file_size(path, fault);
  std::ifstream file(path, std::ios::binary);
  Head head, expected;
  file.read(reinterpret_cast<char*>(&head), sizeof head);
  if (!file || head.name != expected.name) fail(path, "is not a bake of this version");
  if (head.plan != plan) fail(path, "is the bake of something else");
  if (head.size != size - sizeof head) fail(path, "is damaged: its size is wrong");
  if (head.size > most_bytes) fail(path, "has more than " + std::to_string(most_bytes) + " bytes");
  KeptBake kept{std::string(head.size, '\0'), head.digest};
  file.read(kept.state.data(), static_cast<std::streamsize>(head.size));
  if (!file || digestOf(kept.state) != head.digest) fail(path, "is damaged");
  return kept;
}

std::string setBakeAside(const std::string& path) {
  const std::string aside = path + kAside;
  std::error_code fault;
  fs::remove_all(aside, fault);
  fs::rename(path, aside, fault);
  if (fault) fail(path, "cannot be renamed: " + fault.message());
  return aside;
}

std::uint64_t writeBake(const std::string& path, std::uint64_t plan, const std::string& state) {
  const fs::path folder = fs::path(path).parent_path();
  std::error_code fault;
  if (!folder.empty()) fs::create_directories(folder, fault);
  Head head;
  head.plan = plan, head.size = state.size(), head.digest = digestOf(state);
  try {
    TemporaryFile file(path);
    file.write(&head, sizeof head);
    file.write(state.data(), state.size());
    file.keep();
  } catch (const std::system_error& error) {
    fail(path, "cannot be written: " + error.code().message());
  }
  return head.digest;
}

std::vector<std::string> bakeFiles(const std::string& folder) {
  std::vector<std::string> files;
  std::error_code fault;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, fault)) {
    const fs::path file = entry.path();
    const bool is_more = file.stem().extension() == kExtension;  // has letters after it
    if (is_more && file.extension() != kAside) removeLeftover(file);
    if ((is_more || file.extension() == kExtension) && fs::is_regular_file(file, fault))
      files.push_back(file);
  }
  return files;
}

}  // namespace saccade
