// Lowers the priority of threads that compute, so that threads that serve clients run first.
#pragma once

namespace saccade {

// Lowers that of the calling thread, for good.
void lowerPriority();

}  // namespace saccade
