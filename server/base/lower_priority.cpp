#include "base/lower_priority.h"

#include <sys/resource.h>

namespace saccade {

void lowerPriority() {
  constexpr int kNiceness = 5;
  setpriority(PRIO_PROCESS, 0, getpriority(PRIO_PROCESS, 0) + kNiceness);
}

}  // namespace saccade
