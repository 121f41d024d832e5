#pragma once

// rig.json: camera and lights. The built-in resources/rigs/monitor.json shows the fields.

#include <string>
#include <string_view>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/rig/rig.h"

namespace cutis {

std::vector<std::string> rigNames();

// A built-in name or a path; a relative path starts at `folder` (empty: working directory). Checked
// with validate(). `place` stands in front of an error about the name itself; `notice` hears what
// of its files of spectra was left out.
Result<Rig> loadRig(const std::string& nameOrPath, const std::string& folder,
                    const std::string& place, const Notice& notice = {});

}  // namespace cutis
