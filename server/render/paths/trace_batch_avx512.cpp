#include "render/paths/trace_batch_kernel.h"

namespace saccade {

template <>
TraceBatch<1> batchTracerAvx512<1>(bool mixed, bool split) {
  return detail::batchTracer<16, 1>(mixed, split);
}
template <>
TraceBatch<3> batchTracerAvx512<3>(bool mixed, bool split) {
  return detail::batchTracer<16, 3>(mixed, split);
}

}  // namespace saccade
