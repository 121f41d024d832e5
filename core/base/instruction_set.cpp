#include "core/base/instruction_set.h"

#include <array>
#include <cstdint>

#include <hwy/highway.h>

#include "core/base/echoed_text.h"

namespace cutis {
namespace {

struct NamedTarget {
  const char* name;
  std::int64_t target;
};

constexpr std::array<NamedTarget, 4> kTargets = {
    {{"scalar", HWY_SCALAR}, {"sse4", HWY_SSE4}, {"avx2", HWY_AVX2}, {"avx512", HWY_AVX3}}};

std::int64_t bestTarget() {
  // Highway numbers better targets lower.
  const std::int64_t targets = hwy::SupportedTargets() & HWY_TARGETS;
  return targets & -targets;
}

}  // namespace

std::string instructionSetName() {
  for (const NamedTarget& entry : kTargets) {
    if (entry.target == bestTarget()) return entry.name;
  }
  return hwy::TargetName(bestTarget());
}

Status pinInstructionSet(const std::string& name) {
  hwy::SetSupportedTargetsForTest(0);
  if (name.empty()) return {};
  std::string known;
  for (const NamedTarget& entry : kTargets) {
    if (name == entry.name) {
      if ((hwy::SupportedTargets() & HWY_TARGETS & entry.target) == 0) {
        return usageError("CUTIS_ISA", "this processor or build has no " + name + "; use " +
                                           instructionSetName() + " or leave it unset");
      }
      hwy::SetSupportedTargetsForTest(entry.target);
      return {};
    }
    known += known.empty() ? entry.name : std::string(", ") + entry.name;
  }
  return usageError("CUTIS_ISA", "unknown instruction set " + inQuotes(name) + "; use one of " +
                                     known + " or leave it unset");
}

}  // namespace cutis
