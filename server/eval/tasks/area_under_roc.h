// How well a score tells two classes apart.
#pragma once

#include <vector>

namespace saccade::eval {

struct Scored {
  double score;
  bool positive;
};

// The area under the receiver operating characteristic. It is the odds that a random positive scores higher
// than a random negative, where a tie counts half [HM82]. 1 is perfect, and 0.5 is chance. NaN unless there
// are both. Reorders `all`.
//
// [HM82] Hanley and McNeil, The meaning and use of the area under a ROC curve, Radiology 1982.
double areaUnderRoc(std::vector<Scored>& all);

}  // namespace saccade::eval
