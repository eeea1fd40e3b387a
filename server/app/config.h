// What the server is told on its command line.
#pragma once

#include <string>

namespace saccade {

struct Config {
  // Where to listen. Port 0 or * takes a free one; the `ready` line of the log states the real ones.
  std::string control = "tcp://127.0.0.1:5770";
  std::string data = "tcp://127.0.0.1:5771";
  std::string broadcast = "tcp://127.0.0.1:5772";
  int threads = 0;                 // [1, 1024]; 0: one per core
  std::string scenes;              // folder with a folder for each scene; empty: findScenes()
  std::string accuracy;            // file of saccade-eval chart, see AccuracySource; empty: none
  std::string log_level = "info";  // trace, debug, info, warning, error, critical, off
};

// Parses the command line. --help and faults print and end the program.
Config parseConfig(int argc, const char* const* argv);

// The scenes of the installation this program belongs to, else of the source tree it was built from.
std::string findScenes();

}  // namespace saccade
