#include "farm/worker/worker_file.h"

#include <fcntl.h>
#include <unistd.h>

#include <array>
#include <cctype>
#include <cerrno>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <random>
#include <stdexcept>
#include <system_error>
#include <utility>

#include "farm/dataset/json_file.h"

namespace saccade::farm {
namespace {

namespace fs = std::filesystem;

std::string hostName() {
  std::array<char, 256> name{};
  gethostname(name.data(), name.size() - 1);
  return name.data();
}

// Names of folders may be long on no file system, and have no dot: partial/NUMBER.NAME is split there.
std::string newName() {
  std::string host = hostName().substr(0, 64);
  for (char& letter : host)
    if (!std::isalnum(static_cast<unsigned char>(letter))) letter = '-';
  std::array<char, 8> random{};
  std::snprintf(random.data(), random.size(), "%06x", std::random_device{}() & 0xffffffu);
  return host + "-" + std::to_string(getpid()) + "-" + random.data();
}

struct flock wholeFile() {
  struct flock whole {};
  whole.l_type = F_WRLCK, whole.l_whence = SEEK_SET;
  return whole;
}

// Whether nobody has the lock. A file system that knows no locks says that somebody has.
bool isFree(const fs::path& path) {
  const int file = open(path.c_str(), O_RDWR | O_CLOEXEC);
  if (file < 0) return errno == ENOENT;
  struct flock found = wholeFile();
  const bool told = fcntl(file, F_OFD_GETLK, &found) == 0;
  ::close(file);
  return told && found.l_type == F_UNLCK;
}

std::vector<fs::path> entriesOf(const fs::path& folder) {
  std::error_code none;
  std::vector<fs::path> paths;
  for (const auto& entry : fs::directory_iterator(folder, none)) paths.push_back(entry.path());
  return paths;
}

}  // namespace

WorkerFile::WorkerFile(const DataSet& set)
    : name_(newName()), path_(set.workersFolder() / (name_ + ".json")), owner_(getpid()) {
  fs::create_directories(set.workersFolder());
  file_ = open(path_.c_str(), O_RDWR | O_CREAT | O_EXCL, 0666);
  if (file_ < 0) throw std::system_error(errno, std::generic_category(), path_);
  struct flock whole = wholeFile();
  fcntl(file_, F_OFD_SETLK, &whole);  // without locks, leftovers stay until somebody removes them
  first_.set_host(hostName());
  first_.set_process(static_cast<std::uint64_t>(owner_));
  first_.set_begun_unix_s(std::time(nullptr));
  tell({});
}

WorkerFile::~WorkerFile() {
  ::close(file_);
  std::error_code gone;
  if (getpid() == owner_) fs::remove(path_, gone);
}

void WorkerFile::tell(v1::FarmWorker state) {
  state.set_host(first_.host());
  state.set_process(first_.process());
  state.set_begun_unix_s(first_.begun_unix_s());
  state.set_last_unix_s(std::time(nullptr));
  const std::string text = jsonLine(state);
  // A disk that is full keeps the last state.
  if (pwrite(file_, text.data(), text.size(), 0) == static_cast<ssize_t>(text.size()))
    static_cast<void>(ftruncate(file_, static_cast<off_t>(text.size())));
}

std::vector<v1::FarmWorker> liveWorkers(const DataSet& set) {
  std::vector<v1::FarmWorker> workers;
  for (const fs::path& path : entriesOf(set.workersFolder())) {
    if (isFree(path)) continue;
    try {
      workers.push_back(readJson<v1::FarmWorker>(path));
    } catch (const std::runtime_error&) {
      // It has ended meanwhile, or is just writing.
    }
  }
  return workers;
}

void removeLeftovers(const DataSet& set) {
  std::error_code gone;
  for (const fs::path& path : entriesOf(set.partialFolder())) {
    const std::string worker = path.filename().string().substr(path.filename().string().find('.') + 1);
    // A worker of a run is NAME.INDEX.
    const fs::path file = set.workersFolder() / (worker.substr(0, worker.find('.')) + ".json");
    if (isFree(file)) fs::remove_all(path, gone);
  }
  for (const fs::path& path : entriesOf(set.workersFolder()))
    if (isFree(path)) fs::remove(path, gone);
  for (const fs::path& path : entriesOf(set.folder() / "failed")) removeLeftTexts(path);
}

}  // namespace saccade::farm
