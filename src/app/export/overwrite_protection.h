#pragma once

// Files that are read are never written to.

#include <string>
#include <vector>

#include "core/base/result.h"

namespace cutis {

// A usage error if the output is one of the inputs or of the files that they name, under whatever
// name or link. Empty names are passed over.
Status checkNotInput(const std::string& output, const std::vector<std::string>& inputs);

}  // namespace cutis
