// Alone here, so that the other sources are compiled once for all targets.
#include "fuzz/mutants.h"

namespace saccade {

const char* corpusFolder() {
  return SACCADE_CORPUS;
}

}  // namespace saccade
