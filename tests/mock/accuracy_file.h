// A table of accuracy for tests, in a file of its own. At half its width and height and half its C, times are
// a quarter and event rates twice what it says.
#pragma once

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <string>

#include "base/cpu_name.h"

namespace saccade {

class AccuracyFile {
 public:
  explicit AccuracyFile(const std::string& folder, const std::string& cpu = cpuName())
      : settings_("cpu=\"" + cpu + "\" trajectory=right size=64x48 bounces=2 threshold=0.2"),
        path_(folder + "/results.csv") {
    std::filesystem::create_directories(folder);
    std::ofstream(path_) << "# " << settings_ << "\n"
                         << "scene,method,spp,cpu_ms,false_events,missed_events\n"
                            "cornell-box,event_svgf:iterations=2,4,40,0.01,0.02\n"
                            "cornell-box,event_svgf,2,20,0.02,0.03\n"
                            "cornell-box,svgf:as_falcor=1,1,12,0.05,0.06\n"
                            "cornell-box,pt,1,4,0.5,0.1\n";
  }
  ~AccuracyFile() { std::filesystem::remove_all(std::filesystem::path(path_).parent_path()); }
  const std::string& settings() const { return settings_; }
  const std::string& path() const { return path_; }

 private:
  const std::string settings_, path_;
};

}  // namespace saccade
