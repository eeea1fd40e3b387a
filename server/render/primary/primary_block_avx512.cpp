#include "render/primary/primary_block_kernel.h"

namespace saccade {

void tracePrimaryBlockAvx512(const PixelContext& view, Tile pixels, GBuffer& g, PrimaryBlock& out) {
  detail::tracePrimaryBlock<16>(view, pixels, g, out);
}

}  // namespace saccade
