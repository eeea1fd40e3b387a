// Where relativeL1() used to be: for includers of the old name.
#pragma once

#include "eval/metrics/plane_error.h"
