#include "base/names.h"
#include "events/reconstruction.h"
#include "events/reconstruction/reconstructions.h"

namespace saccade {

const std::vector<ReconstructionInfo>& reconstructionTable() {
  static const std::vector<ReconstructionInfo> table = {
      {"direct", "believes the difference alone; drifts [E (22)]", makeDirect},
      {"complementary", "the difference above a cutoff frequency, the primal below", makeComplementary},
      {"kalman", "difference and primal, weighed by their variances", makeKalman},
  };
  return table;
}

const ReconstructionInfo* findReconstruction(const std::string& name) {
  return findRow(reconstructionTable(), name);
}

std::string reconstructionNames() {
  return joinRowNames(reconstructionTable());
}

}  // namespace saccade
