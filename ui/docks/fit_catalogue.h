#pragma once  // internal to ui/docks

// What the fit panel offers, in the words of the window.

#include <vector>

#include <QString>

#include "core/fit/fit_options.h"

namespace cutis {

struct MethodDescription {
  FitMethod method;
  QString name;
  QString toolTip;  // what it is good for
};

const std::vector<MethodDescription>& methodCatalogue();

// What a profile is good for; empty for those that are not built in.
QString profileToolTip(const QString& profile);

}  // namespace cutis
