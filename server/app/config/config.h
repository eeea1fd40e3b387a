// The server's configuration. ConfigSources says where its values come from.
#pragma once

#include <string>

#include "app/admission/limits.h"
#include "scene/files/search_folders.h"

namespace CLI {
class App;
}

namespace saccade {

struct Config {
  // Where to listen: tcp:// or ipc://. Port 0 or * takes a free one; the log's line `ready` names it.
  std::string control = "tcp://127.0.0.1:5770";
  std::string data = "tcp://127.0.0.1:5771";
  std::string broadcast = "tcp://127.0.0.1:5772";
  std::string http = "off";           // address of the pages, such as http://127.0.0.1:5773; "off": none
  std::string viewer = "auto";        // "on", "off"; "auto": on loopback, and without keys or with viewer_key
  std::string viewer_key;             // file of the secret key with which viewers are clients; empty: none
  double drain_s = 5;                 // [0, 3600] how long stop() waits for receivers
  double lease_s = 30;                // [0.1, 86400] how long a stream lives without a receiver
  std::string secret_key;             // file of the server's own key; empty: no keys
  std::string client_keys;            // file of the clients' keys, see ClientKeys; given where secret_key is
  bool insecure = false;              // whether other machines may connect without keys
  int threads = 0;                    // [1, 1024]; 0: one per core
  std::string instructions = "auto";  // "avx2", "avx512"; "auto": the widest of this processor
  std::string scenes;                 // folder with a folder for each scene; empty: findScenes()
  std::string meshes = kDefaultMeshes;  // folders of meshes that scenes do not hold, see splitFolders()
  std::string accuracy;                 // file of saccade-eval chart, see AccuracySource; empty: none
  std::string simplification;  // file of saccade-eval simplification, see SimplificationSource; empty: none
  std::string bakes;           // folder of bakes, see BakeStore; empty: streams cannot have one
  Limits limits;
  std::string log_level = "info";   // trace, debug, info, warning, error, critical, off
  std::string log_format = "text";  // text, json
  friend bool operator==(const Config&, const Config&) = default;
};

// Adds the options that may be configured. They set `config`, whose values at the call are the defaults.
void addOptions(CLI::App& app, Config& config);

struct CommandLine {
  Config config;
  bool check = false;  // --check-config: do not serve
};

// Reads the command line, the environment and the file that one of them names. --help, --version and
// --print-config print and end the program. So does a fault, with exit status 2.
CommandLine parseCommandLine(int argc, const char* const* argv);

}  // namespace saccade
