#pragma once  // internal to ui/inspector

// A view's values as a histogram.

#include "src/app/views/view_part.h"
#include "ui/plot/histogram_plot.h"
#include "ui/view/view_catalogue.h"

namespace cutis {

// Of the samples of a part of the view with an estimate, without those that are not finite: of a
// map over its range, of colours one curve for red, green and blue, from 0 to 1 or as far as nearly
// all of them reach. pixels: that the whole picture has. Some milliseconds for 512² samples.
HistogramSpec histogramOf(const ViewPart& part, const ViewDescription& view, const QString& name,
                          std::size_t pixels);

}  // namespace cutis
