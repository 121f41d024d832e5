#pragma once

// What the user should know of a fit that is complete.

#include <QString>

#include "core/fit/fit_run.h"

namespace cutis {

struct FitRemark {
  QString sentence;  // empty if all is well
  bool isError = false;
};

FitRemark remarkOn(const FitStatistics& statistics);

}  // namespace cutis
