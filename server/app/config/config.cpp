#include "app/config/config.h"

#include <CLI/CLI.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>

#include "app/config/config_sources.h"
#include "app/config/option_faults.h"
#include "base/default_cache.h"
#include "base/new_folder.h"
#include "base/number_in.h"
#include "base/tile_pool.h"
#include "scene/library/find_scenes.h"
#include "stream/bounded_peers.h"
#include "stream/endpoint.h"
#include "tables/accuracy_table.h"
#include "tables/simplification_table.h"

namespace saccade {
namespace {

// `path` where the file exists, else empty.
std::string ifThere(const std::string& path) {
  std::error_code none;
  return std::filesystem::exists(path, none) ? path : "";
}

constexpr int kUsage = 2;            // exit status
constexpr double kUnlimited = 1e12;  // more than any machine has

// A limit without a unit is a count.
CLI::Validator checkOf(const LimitRow& row) {
  if (*row.unit) return NumberIn(row.min, kUnlimited);
  return NumberIn(std::llround(row.min), std::llround(kUnlimited));
}

void addLimits(CLI::App& app, Limits& limits) {
  for (const LimitRow& row : kLimitTable) {
    char fallback[32];
    std::snprintf(fallback, sizeof fallback, "%.15g", limits[row.limit]);
    const std::string unit = row.unit;
    app.add_option(std::string("--limit-") + row.name, limits[row.limit],
                   (unit.empty() ? "" : unit + ": ") + row.what)
        ->group("Limits, of all clients and of one")
        ->check(checkOf(row))
        ->default_str(fallback);
  }
}

// Actions of the command line besides the configuration.
struct CliAction {
  std::string file;
  bool print = false, check = false;
};

void addActions(CLI::App& app, CliAction& action) {
  app.add_option("--config", action.file,
                 "TOML file of these options; default: the file that SACCADE_CONFIG names")
      ->check(CLI::ExistingFile)
      ->configurable(false);
  app.add_flag("--print-config", action.print,
               "print every option with its value and origin as such a file, and exit")
      ->configurable(false);
  app.add_flag("--check-config", action.check,
               "check all that a start would, such as files, folders and free ports, and exit")
      ->configurable(false);
  app.set_version_flag("--version", SACCADE_VERSION)->configurable(false);
  app.get_help_ptr()->configurable(false);
  app.footer(
      "An ENDPOINT is tcp://ADDRESS:PORT, or ipc://FILE for clients on this machine. Port 0 takes a free "
      "port; the log line `ready:` names it.\n\n"
      "A flag beats the environment (SACCADE_LOG_LEVEL for --log-level), which beats the file of --config "
      "(log-level = \"debug\")." +
      (peersAreBounded() ? std::string() : std::string("\n\nNote: ") + kUnboundedPeers + "."));
}

void tell(const CliAction& action, const ConfigSources& sources) {
  for (const std::string& warning : sources.warnings())
    std::fprintf(stderr, "saccaded: %s\n", warning.c_str());
  if (action.print) std::fputs(sources.describe().c_str(), stdout);
  if (action.print && !action.check) std::exit(0);
}

// Throws std::runtime_error for what no option can check by itself.
void checkTogether(const Config& config) {
  if (!std::filesystem::is_directory(config.scenes))
    throw std::runtime_error("--scenes: there is no folder '" + config.scenes + "'");
  const auto refuseTwin = [](const std::string& option, const std::string& endpoint, const std::string& first,
                             const std::string& taken) {
    if (endpoint == taken && hasOnePlace(endpoint))
      throw std::runtime_error(option + ": " + endpoint + " is the address of " + first + ", too");
  };
  refuseTwin("--data", config.data, "--control", config.control);
  refuseTwin("--broadcast", config.broadcast, "--control", config.control);
  refuseTwin("--broadcast", config.broadcast, "--data", config.data);
}

Config defaultConfig() {
  Config config;
  config.http = "http://127.0.0.1:5773";
  config.scenes = findScenes();
  config.bakes = defaultCache() + "/bakes";
  config.accuracy = ifThere(defaultAccuracyTable());
  config.simplification = ifThere(defaultSimplificationTable());
  return config;
}

}  // namespace

void addOptions(CLI::App& app, Config& config) {
  const CLI::Validator endpoint(endpointFault, "ENDPOINT");
  app.add_option("--control", config.control, "socket for requests")->check(endpoint)->capture_default_str();
  app.add_option("--data", config.data, "socket for lossless and live streams")
      ->check(endpoint)
      ->capture_default_str();
  app.add_option("--broadcast", config.broadcast, "socket for broadcast streams")
      ->check(endpoint)
      ->capture_default_str();
  app.add_option("--http", config.http, "address of the viewer, /metrics, /healthz and /readyz; off: none")
      ->check(httpFault)
      ->capture_default_str();
  app.add_option(
         "--viewer", config.viewer,
         "whether browsers may watch at --http; auto: on loopback, and with keys only by --viewer-key")
      ->check(CLI::IsMember({"auto", "on", "off"}))
      ->capture_default_str();
  app.add_option("--viewer-key", config.viewer_key,
                 "file of the secret key that browsers use; its public key is one of --client-keys")
      ->capture_default_str();
  app.add_option("--drain-time", config.drain_s,
                 "seconds that receivers have on SIGTERM to take the packets that are left")
      ->check(NumberIn(0.0, 3600.0))
      ->capture_default_str();
  app.add_option("--lease", config.lease_s,
                 "seconds that a stream without a receiver lives on and can be resumed")
      ->check(NumberIn(0.1, 86400.0))
      ->capture_default_str();
  app.add_option("--secret-key", config.secret_key, "file of the server's secret key, from `saccade keygen`")
      ->capture_default_str();
  app.add_option("--client-keys", config.client_keys,
                 "file with a line KEY NAME, or KEY NAME admin, for each client; SIGHUP reads it again")
      ->capture_default_str();
  app.add_flag("--insecure", config.insecure, "let other machines connect without keys")
      ->check(CLI::IsMember({"true", "false"}));  // CLI11 by itself takes 10 for true
  app.add_option("--threads", config.threads, "threads that render; 0: one per CPU that this process may use")
      ->check(NumberIn(0, 1024))
      ->capture_default_str();
  app.add_option("--instructions", config.instructions,
                 "vector instructions to render with; auto: the widest of this processor")
      ->check(CLI::IsMember({"auto", "avx2", "avx512"}))
      ->check(instructionsFault)
      ->capture_default_str();
  app.add_option("--scenes", config.scenes, "folder of the scenes")
      ->check(CLI::ExistingDirectory)
      ->capture_default_str();
  app.add_option("--meshes", config.meshes,
                 "folders, separated by ':', of meshes that scenes name but do not hold themselves")
      ->check(foldersFault)
      ->capture_default_str();
  app.add_option("--accuracy", config.accuracy,
                 "table for streams with a budget: results.csv of `saccade-eval chart`; default: " +
                     defaultAccuracyTable() + ", if it is there")
      ->check(CLI::ExistingFile)
      ->default_str(config.accuracy);
  app.add_option("--simplification", config.simplification,
                 "table for streams with a max_event_change, of `saccade-eval simplification`; default: " +
                     defaultSimplificationTable() + ", if it is there")
      ->check(CLI::ExistingFile)
      ->default_str(config.simplification);
  app.add_option("--bakes", config.bakes,
                 "folder for light that streams let the server compute ahead; empty: they cannot")
      ->check(newFolderFault)
      ->capture_default_str();
  app.add_option("--log-level", config.log_level, "least severity that is logged")
      ->check(CLI::IsMember({"trace", "debug", "info", "warning", "error", "critical", "off"}))
      ->capture_default_str();
  app.add_option("--log-format", config.log_format, "lines for people, or for machines")
      ->check(CLI::IsMember({"text", "json"}))
      ->capture_default_str();
  addLimits(app, config.limits);
}

CommandLine parseCommandLine(int argc, const char* const* argv) {
  CommandLine line{.config = defaultConfig()};
  Config& config = line.config;
  CliAction action;
  CLI::App app("saccaded: renders scenes, and streams what an event camera would see of them");
  addOptions(app, config);
  addActions(app, action);
  try {
    app.parse(argc, argv);
    const char* file = std::getenv("SACCADE_CONFIG");
    if (action.file.empty() && file) action.file = file;
    tell(action, ConfigSources(app, action.file));
    checkTogether(config);
  } catch (const CLI::ParseError& fault) {
    std::exit(app.exit(fault) == 0 ? 0 : kUsage);
  } catch (const std::exception& fault) {
    std::fprintf(stderr, "saccaded: %s\n", fault.what());
    std::exit(kUsage);
  }
  if (config.threads == 0) config.threads = hardwareThreads();
  line.check = action.check;
  return line;
}

}  // namespace saccade
