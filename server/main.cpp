#include <spdlog/spdlog.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>

#include "app/app.h"
#include "base/instruction_set.h"
#include "base/one_heap.h"
#include "log/log.h"

namespace {

// Call it before anything else: on an older CPU even the parsing of flags may use a missing instruction.
bool cpuSuffices() {
  const std::string_view arch = SACCADE_ARCH;
  __builtin_cpu_init();
  const bool v3 =
      __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("fma");
  if (arch != "x86-64-v4") return v3;
  return v3 && saccade::widestInstructionSet() == saccade::InstructionSet::kAvx512;
}

constexpr rlim_t kLeastFiles =
    64;  // half for a server without clients: libzmq ends the program where it gets none

// Each connection takes a file descriptor.
void openAsManyFilesAsAllowed() {
  rlimit files{};
  if (getrlimit(RLIMIT_NOFILE, &files) != 0) return;
  files.rlim_cur = files.rlim_max;
  setrlimit(RLIMIT_NOFILE, &files);
  if (files.rlim_max < kLeastFiles)
    throw std::runtime_error("saccaded may open " + std::to_string(files.rlim_max) + " files, and needs " +
                             std::to_string(kLeastFiles) + ": raise the limit, as by `ulimit -n`");
}

sigset_t blockSignals() {
  sigset_t signals;
  sigemptyset(&signals);
  sigaddset(&signals, SIGTERM);
  sigaddset(&signals, SIGINT);
  sigaddset(&signals, SIGHUP);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);
  return signals;
}

// Whether the server could serve, as an exit status.
int check(const saccade::Config& config) {
  spdlog::set_level(spdlog::level::off);
  try {
    openAsManyFilesAsAllowed();
    saccade::App::check(config);
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "saccaded: %s\n", fault.what());
    return 2;
  }
  std::fputs("the configuration is valid\n", stderr);
  return 0;
}

// Serves until a signal comes. Returns the exit status.
int serve(const saccade::Config& config) {
  const sigset_t signals = blockSignals();  // before the threads that inherit it
  try {
    openAsManyFilesAsAllowed();
    if (config.instructions != "auto") saccade::useInstructionSet(config.instructions);
    saccade::App app(config);
    int signal = 0;
    while (sigwait(&signals, &signal) == 0 && signal == SIGHUP) app.reloadKeys();
    spdlog::info("signal {}: ending all streams", signal);
    pthread_sigmask(SIG_UNBLOCK, &signals, nullptr);  // a second signal ends the program at once
    if (!app.stop()) {
      spdlog::warn("stopped before all streams were done");
      saccade::finishLog();
      std::_Exit(0);  // all sockets are closed; a frame may go on for minutes
    }
  } catch (const std::exception& fault) {
    spdlog::critical(fault.what());
    return 1;
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  saccade::useOneHeap();
  if (!cpuSuffices()) {
    std::fputs("saccaded was built for " SACCADE_ARCH
               ", and this CPU lacks its instructions; build it with -DSACCADE_ARCH=native on this machine\n",
               stderr);
    return 1;
  }
  const auto [config, check_only] = saccade::parseCommandLine(argc, argv);
  std::signal(SIGPIPE, SIG_IGN);  // the reader of the log may end
  if (check_only) return check(config);
  saccade::setUpLog(config.log_level, config.log_format);
  const int status = serve(config);
  if (!saccade::finishLog()) std::_Exit(status);  // its thread waits for a reader
  return status;
}
