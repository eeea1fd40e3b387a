# skip REASON: ctest calls the test skipped. need COMMAND...: skips where one is missing. need_full: unless asked for.
skip() { echo "skipped: $*"; exit 77; }
need() { for tool in "$@"; do command -v "$tool" >/dev/null || skip "$tool is not installed"; done; }
need_full() { [ -n "${SACCADE_FULL:-}" ] || skip "takes minutes; set SACCADE_FULL=1"; }
