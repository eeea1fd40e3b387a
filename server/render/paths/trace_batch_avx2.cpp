#include "render/paths/trace_batch_kernel.h"

namespace saccade {

template <>
TraceBatch<1> batchTracerAvx2<1>(bool mixed, bool split) {
  return detail::batchTracer<8, 1>(mixed, split);
}
template <>
TraceBatch<3> batchTracerAvx2<3>(bool mixed, bool split) {
  return detail::batchTracer<8, 3>(mixed, split);
}

}  // namespace saccade
