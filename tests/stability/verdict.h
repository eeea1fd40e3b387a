// The stability suite's expectations of methods.
#pragma once

#include "stability/comparison.h"

namespace saccade::test {

// Of all methods: they are finite everywhere, and make as many events as a sensor lets through.
void expectSound(const StabilityCase& c, const MethodFigures& figures);

// Of the method of a claim: it keeps its bound, and does not clearly lose to a rival unless the case gives
// the reason. Each method of the table is a rival of the default method. Other claimed methods have rivals
// that do not change, so that losing to them is a regression.
void expectKept(const Claim& claim, const StabilityCase& c, const MethodFigures& figures);

// Of the method of a claim: it is no worse than `before`, when the camera saw the same a lap earlier.
void expectNoWorse(const Claim& claim, const StabilityCase& c, const MethodFigures& figures,
                   const MethodFigures& before);

}  // namespace saccade::test
