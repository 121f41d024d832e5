#pragma once

// Which of the compiled vector instruction sets the kernels run on.

#include <string>

#include "core/base/result.h"

namespace cutis {

// The best one this processor has, or the one pinned: "scalar", "sse4", "avx2" or "avx512".
std::string instructionSetName();

// Restricts the kernels to `name` (one of the above). Fails with a sentence if the name is unknown
// or the processor lacks it. Not thread-safe: call it before any kernel runs; programs do so with
// the value of $CUTIS_ISA. An empty name means the best there is.
Status pinInstructionSet(const std::string& name);

}  // namespace cutis
