// Minimises functions of few variables without derivatives.
#pragma once

#include <functional>
#include <vector>

namespace saccade::eval {

using Variables = std::vector<double>;

// A local minimum of `f` near `start`, by a simplex [NM65] with their coefficients 1, 2 and 1/2. `step`: of
// the first simplex along each variable. Stops when the simplex is smaller than `tolerance` along all
// variables, or after about `most_calls` of `f`.
//
// [NM65] Nelder and Mead, A simplex method for function minimization, The Computer Journal 1965.
Variables minimise(const std::function<double(const Variables&)>& f, const Variables& start, double step,
                   double tolerance, int most_calls = 300);

}  // namespace saccade::eval
