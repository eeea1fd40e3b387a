#include "base/default_cache.h"

#include <cstdlib>

namespace saccade {

std::string defaultCache() {
  const char *cache = std::getenv("XDG_CACHE_HOME"), *home = std::getenv("HOME");
  if (cache && *cache) return std::string(cache) + "/saccade";
  return home ? std::string(home) + "/.cache/saccade" : "out/cache";
}

}  // namespace saccade
