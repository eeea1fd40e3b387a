// The parts of a pod whose data set lies in a bucket.
#pragma once

#include <string>

#include "farm/dataset/data_set.h"
#include "farm/engines/kubernetes.h"

namespace saccade::farm {

// Throws std::invalid_argument where a name or the place is none.
void checkBucket(const Bucket& bucket);

// Lines of the manifest, as kubernetes.cpp puts them together.
std::string bucketInit(const Bucket& bucket);                                // the pod's first container
std::string bucketCommand(const DataSet& set, const KubernetesOptions& of);  // command and env of the worker
std::string bucketMounts();
std::string bucketVolumes(const Bucket& bucket);

}  // namespace saccade::farm
