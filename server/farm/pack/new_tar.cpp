#include "farm/pack/new_tar.h"

#include <random>
#include <system_error>

#include "farm/dataset/durable.h"

namespace saccade::farm {
namespace {

namespace fs = std::filesystem;

constexpr const char* kPartial = ".partial";

// No other program, on any host, has it.
fs::path partialName(const fs::path& path) {
  return path.string() + "." + std::to_string(std::random_device()()) + kPartial;
}

}  // namespace

NewTar::NewTar(const fs::path& path) : path_(path), partial_(partialName(path)), writer_(partial_) {}

NewTar::~NewTar() {
  std::error_code gone;
  fs::remove(partial_, gone);
}

void NewTar::publish() {
  writer_.close();
  flushFile(partial_);
  fs::rename(partial_, path_);
  flushFile(path_.parent_path());
}

void removePartialTars(const fs::path& folder) {
  std::error_code none;
  for (const auto& entry : fs::directory_iterator(folder, none))
    if (entry.path().extension() == kPartial && !client::isBeingWritten(entry.path()))
      fs::remove(entry.path(), none);
}

}  // namespace saccade::farm
