// What is kept between runs of the programs.
#pragma once

#include <string>

namespace saccade {

// $XDG_CACHE_HOME/saccade, else ~/.cache/saccade, else out/cache. It may not be there yet.
std::string defaultCache();

}  // namespace saccade
