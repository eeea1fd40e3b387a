// Who works long leaves the processor to who answers clients or sends packets.
#pragma once

namespace saccade {

// Of the calling thread alone, for good.
void lowerPriority();

}  // namespace saccade
