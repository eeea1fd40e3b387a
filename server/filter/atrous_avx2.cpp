#include "filter/atrous_taps.h"

namespace saccade {

void filterChunkAvx2(AtrousSignal signal, const AtrousChunk& chunk) {
  detail::filterChunk<8>(signal, chunk);
}

}  // namespace saccade
