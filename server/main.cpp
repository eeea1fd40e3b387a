#include <malloc.h>
#include <spdlog/spdlog.h>
#include <sys/resource.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <string_view>

#include "app/app.h"
#include "ops/log.h"

namespace {

// Before anything else: on a lesser CPU even the parsing of flags may meet an instruction that is not there.
bool cpuSuffices() {
  const std::string_view arch = SACCADE_ARCH;
  __builtin_cpu_init();
  // Feature by feature: Clang 14 does not know the levels by name.
  const bool v3 =
      __builtin_cpu_supports("avx2") && __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("fma");
  if (arch != "x86-64-v4") return v3;
  return v3 && __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512bw") &&
         __builtin_cpu_supports("avx512cd") && __builtin_cpu_supports("avx512dq") &&
         __builtin_cpu_supports("avx512vl");
}

// Each connection takes a file.
void openAsManyFilesAsAllowed() {
  rlimit files{};
  if (getrlimit(RLIMIT_NOFILE, &files) != 0) return;
  files.rlim_cur = files.rlim_max;
  setrlimit(RLIMIT_NOFILE, &files);
}

// glibc keeps up to eight heaps per CPU, and what one has freed the others cannot use: memory then grows for
// hours while the same streams come and go. Nothing that runs per frame allocates, so one heap is fast
// enough.
void useOneHeap() {
  mallopt(M_ARENA_MAX, 1);
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

// Until a signal ends it. Returns the status to exit with.
int serve(const saccade::Config& config) {
  const sigset_t signals = blockSignals();  // for all threads to come
  try {
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
  useOneHeap();
  if (!cpuSuffices()) {
    std::fputs("saccaded was built for " SACCADE_ARCH
               ", which this CPU is not; build it with -DSACCADE_ARCH=native on this machine\n",
               stderr);
    return 1;
  }
  const saccade::Config config = saccade::parseConfig(argc, argv);
  std::signal(SIGPIPE, SIG_IGN);  // who reads the log may go
  openAsManyFilesAsAllowed();
  saccade::setUpLog(config.log_level, config.log_format);
  const int status = serve(config);
  if (!saccade::finishLog()) std::_Exit(status);  // its thread waits for a reader
  return status;
}
