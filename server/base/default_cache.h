// The folder for files that the programs keep between runs.
#pragma once

#include <string>

namespace saccade {

// $XDG_CACHE_HOME/saccade, else ~/.cache/saccade, else out/cache. It may not exist yet.
std::string defaultCache();

}  // namespace saccade
