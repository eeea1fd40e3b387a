// Tests that need the libzmq of deploy/libzmq/build, or the system's. Others skip them by name.
#pragma once

#include <gtest/gtest.h>

#include "stream/bounded_peers.h"

#define NEEDS_PATCHED_LIBZMQ() \
  if (!peersAreBounded()) GTEST_SKIP() << "this build has the system's libzmq: see deploy/libzmq/README.md"
#define NEEDS_SYSTEMS_LIBZMQ() \
  if (peersAreBounded()) GTEST_SKIP() << "this build has the libzmq of deploy/libzmq/build"
