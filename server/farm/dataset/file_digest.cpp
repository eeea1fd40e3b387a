#include "farm/dataset/file_digest.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <system_error>
#include <vector>

#include "client/recording/digest.h"

namespace saccade::farm {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kChunk = 1 << 18;

}  // namespace

std::string digestOfFile(const std::string& file) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> input(std::fopen(file.c_str(), "rb"), std::fclose);
  if (!input) throw std::system_error(errno, std::generic_category(), file);
  std::vector<char> chunk(kChunk);
  client::Digest digest;
  std::size_t read = 0;
  while ((read = std::fread(chunk.data(), 1, chunk.size(), input.get())) > 0)
    digest.add({chunk.data(), read});
  if (std::ferror(input.get())) throw std::system_error(errno, std::generic_category(), file);
  return digest.hex();
}

std::vector<v1::DataSetFile> filesOf(const std::string& folder) {
  std::vector<v1::DataSetFile> files;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (!entry.is_regular_file()) continue;
    v1::DataSetFile& file = files.emplace_back();
    file.set_name(entry.path().lexically_relative(folder));
    file.set_bytes(entry.file_size());
    file.set_digest(digestOfFile(entry.path()));
  }
  std::ranges::sort(files, {}, [](const v1::DataSetFile& file) { return file.name(); });
  return files;
}

std::string digestOfFolder(const std::string& folder) {
  client::Digest digest;
  for (const v1::DataSetFile& file : filesOf(folder)) {
    digest.add({file.name().c_str(), file.name().size() + 1});  // with the 0 behind it
    digest.add(file.digest());
  }
  return digest.hex();
}

}  // namespace saccade::farm
