#include "render/primary/primary_block_kernel.h"

namespace saccade {

void tracePrimaryBlockAvx2(const PixelContext& view, Tile pixels, GBuffer& g, PrimaryBlock& out) {
  detail::tracePrimaryBlock<8>(view, pixels, g, out);
}

}  // namespace saccade
