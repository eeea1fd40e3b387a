// Compares the files of a data set with what its plan and its digests say.
#pragma once

#include "farm/report/findings.h"

namespace saccade::farm {

// Reads all files of the plan, the recipe and the sequences, and the names of all others. README.md,
// croissant.json, card/ and webdataset/ are passed over, since they can be made again. A file that cannot be
// read, or that is a symbolic link, is damaged. Folders down to those of the shards may be links. `tell`
// hears of each fault: what it is, and of which file. `step` hears of each sequence. The memory it takes does
// not grow with the data set.
Verified verify(const DataSet& set, const std::function<void(const std::string&)>& tell,
                const std::function<void(const Verified&)>& step);

}  // namespace saccade::farm
