"""A source includes the standard headers of what it uses, itself or by headers of the project.

Standard headers include each other differently in each version of a compiler: a source that relies on it
fails to build with another one.
"""
import functools
import re
import unittest

import house

SOURCE_ROOTS = ["", "server", "client", "tests", "proto"]  # of the includes in quotes, beside the file's own folder
ALGORITHMS = ("adjacent_find all_of any_of binary_search clamp copy copy_backward copy_if copy_n count count_if equal "
              "equal_range fill fill_n find find_if find_if_not for_each generate is_sorted lexicographical_compare "
              "lower_bound max max_element merge min min_element minmax_element mismatch none_of nth_element "
              r"partial_sort partition ranges::\w+ remove_if replace reverse rotate search shuffle sort stable_sort "
              "swap_ranges transform unique upper_bound")
NAMES = {
    "algorithm": ALGORITHMS,
    "atomic": "atomic",
    "bit": "bit_cast bit_width countl_zero countr_zero endian popcount",
    "chrono": "chrono",
    "cmath": ("acos asin atan atan2 cbrt ceil copysign cos exp fabs floor fmod hypot isfinite isinf isnan ldexp llround "
              "log log10 log2 lround nextafter pow round sin sqrt tan"),
    "cstring": "memcmp memcpy memmove memset strcmp strlen",
    "fstream": "fstream ifstream ofstream",
    "iterator": "back_inserter inserter istreambuf_iterator next prev",
    "limits": "numeric_limits",
    "map": "map multimap",
    "mutex": "lock_guard mutex unique_lock",
    "numbers": "numbers",
    "numeric": "accumulate gcd inner_product iota lcm midpoint partial_sum reduce",
    "set": "multiset set",
    "sstream": "istringstream ostringstream stringstream",
    "stdexcept": "invalid_argument logic_error out_of_range runtime_error",
    "thread": "jthread this_thread thread",
}
USES = {header: re.compile(rf"std::({'|'.join(names.split())})\b") for header, names in NAMES.items()}


@functools.cache
def resolve(name, folder):
    places = [house.ROOT / root / name for root in SOURCE_ROOTS] + [house.ROOT / folder / name]
    return next((p.relative_to(house.ROOT) for p in places if p.is_file()), None)


def standard_headers(path, seen):
    """The names in angle brackets that `path` and the project's headers below it include."""
    if path is None or path in seen:
        return
    seen.add(path)
    for bracket, name in house.includes(path):
        if bracket == "<":
            yield name
        else:
            yield from standard_headers(resolve(name, path.parent), seen)


class StandardHeaders(unittest.TestCase):
    maxDiff = None

    def test_each_source_includes_those_that_it_uses(self):
        missing = []
        for path in house.files({".cpp"}):
            code = re.sub(r"//.*", "", house.text(path))
            included = set(standard_headers(path, set()))
            missing += [f"{path}: <{header}> for {use[0]}" for header, pattern in USES.items()
                        if header not in included and (use := pattern.search(code))]
        self.assertEqual(missing, [])


if __name__ == "__main__":
    unittest.main()
