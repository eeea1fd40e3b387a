#pragma once
#include "methods/method_spec.h"
