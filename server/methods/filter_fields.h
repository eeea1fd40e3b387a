// The parameters that methods with a history and an a-trous filter share.
#pragma once

#include "methods/param_fields.h"

namespace saccade {

// Their rows for a method with parameters P, followed by `more`. `source`: of the defaults, where methods
// differ.
template <class P>
std::vector<ParamField<P>> withFilterFields(const char* source, const std::vector<ParamField<P>>& more) {
  std::vector<ParamField<P>> fields{
      {"max_history", &P::max_history, 1, 1024, "frames after which the history counts as full", source},
      {"iterations", &P::iterations, 0, 5, "a-trous iterations, of spacing 1, 2, 4, ...", source},
      {"sigma_l", &P::sigma_l, 0.01, 1000, "luminance tolerance of the primal, standard deviations [E (25)]",
       source},
      {"sigma_n", &P::sigma_n, 0, 1024, "normal exponent [E (24)]", "Falcor"},
      {"sigma_z", &P::sigma_z, 0.01, 1000, "depth tolerance, slopes [E (23)]", "Falcor"},
      independentNumbersField<P>(&P::independent_numbers),
  };
  fields.insert(fields.end(), more.begin(), more.end());
  return fields;
}

}  // namespace saccade
