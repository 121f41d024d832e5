#pragma once  // internal to src/cli/commands/validate

// The figures of validate --capture, as tables for people and as comma-separated values.

#include <string>
#include <vector>

#include "core/calibrate/capture_study.h"

namespace cutis {

// Words for what a result names by number.
struct CaptureNames {
  std::vector<std::string> sets;    // without blanks and commas
  std::vector<std::string> models;  // profiles
};

// "refined", "wiener", "wiener2"; the profile after it where there are several.
std::string nameOf(const CaptureResult& result, const CaptureNames& names);
// "people-left-out" and the like; where there are several sets, the one judged on after it, and
// then "from" the one learned from.
std::string schemeOf(const CaptureResult& result, const CaptureNames& names);

// name,scheme,range,median,p95,worst,coverage. Of thirds by tone the scheme ends in dark, middle or
// light. What is not known is left empty; ranges without any figure have no row.
std::string captureCsv(const std::vector<CaptureResult>& results, const CaptureNames& names);

// A table for each range in which there is a figure, of the results of one set, whose name they do
// not repeat.
std::string captureTables(const std::vector<CaptureResult>& results, std::size_t set,
                          const MeasuredSpectra& spectra, const CaptureNames& names);

}  // namespace cutis
