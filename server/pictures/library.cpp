#include "pictures/library.h"

#include <dlfcn.h>

#include <filesystem>
#include <stdexcept>

#include "pictures/module.h"

namespace saccade::pictures {
namespace {

// The module has the same place beside the programs, where they are built and where they are installed.
std::string modulePath() {
  const auto program = std::filesystem::read_symlink("/proc/self/exe");
  return program.parent_path().parent_path() / SACCADE_PICTURES_MODULE;
}

const Library& load() {
  void* const module = dlopen(modulePath().c_str(), RTLD_NOW | RTLD_LOCAL);
  void* const entry = module ? dlsym(module, kEntryName) : nullptr;
  if (!entry) throw std::runtime_error(std::string("the library of pictures is not loaded: ") + dlerror());
  return *reinterpret_cast<Entry*>(entry)();
}

}  // namespace

const Library& library() {
  static const Library& loaded = load();
  return loaded;
}

}  // namespace saccade::pictures
