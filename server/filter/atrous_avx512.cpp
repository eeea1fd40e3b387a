#include "filter/atrous_taps.h"

namespace saccade {

void filterChunkAvx512(AtrousSignal signal, const AtrousChunk& chunk) {
  detail::filterChunk<16>(signal, chunk);
}

}  // namespace saccade
