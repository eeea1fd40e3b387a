#include "eval/tasks/area_under_roc.h"

#include <algorithm>

namespace saccade::eval {

// The statistic of Mann and Whitney: for each run of ties, its pairs with the negatives below and within.
double areaUnderRoc(std::vector<Scored>& all) {
  std::sort(all.begin(), all.end(), [](const Scored& a, const Scored& b) { return a.score < b.score; });
  double positives = 0, negatives = 0, pairs = 0;
  for (auto first = all.begin(); first != all.end();) {
    double positive_ties = 0, negative_ties = 0;
    const double score = first->score;
    for (; first != all.end() && first->score == score; ++first)
      (first->positive ? positive_ties : negative_ties) += 1;
    pairs += positive_ties * (negatives + negative_ties / 2);
    positives += positive_ties, negatives += negative_ties;
  }
  return pairs / (positives * negatives);
}

}  // namespace saccade::eval
