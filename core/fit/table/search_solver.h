#pragma once

// The table searches as pixel solvers, through their exact indices.

#include <memory>

#include "core/fit/pixel_solver.h"
#include "core/fit/table/table_search.h"

namespace cutis {

// channels: the rows of the rig the search was made for.
std::unique_ptr<const PixelSolver> makeFullSearchSolver(
    std::shared_ptr<const TableSearch> search, std::shared_ptr<const ResponseModel> channels);

// caroteneSample: what the first stage fixes, see TableSearch::mostFrequentCarotene().
std::unique_ptr<const PixelSolver> makeThreeStageSolver(
    std::shared_ptr<const TableSearch> search, int caroteneSample,
    std::shared_ptr<const ResponseModel> channels);

}  // namespace cutis
