#pragma once

// The table searches as pixel solvers.

#include <memory>

#include "core/fit/pixel_solver.h"
#include "core/fit/table_search.h"

namespace cutis {

// Residuals are those of the table's entry, in the search's own precision.
std::unique_ptr<const PixelSolver> makeFullSearchSolver(std::shared_ptr<const TableSearch> search,
                                                        std::shared_ptr<const SkinModel> model,
                                                        const Rig& rig);
std::unique_ptr<const PixelSolver> makeThreeStageSolver(std::shared_ptr<const TableSearch> search,
                                                        int caroteneSample,
                                                        std::shared_ptr<const SkinModel> model,
                                                        const Rig& rig);

}  // namespace cutis
