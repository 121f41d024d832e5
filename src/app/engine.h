#pragma once

// What several operations share and what takes time to prepare: compiled profiles, tables, solvers,
// reduced response matrices. The command line and the editor work through the same engine, so that
// the same input gives the same pixels.
//
// Thread-safe. What is asked for twice is made once; two threads that ask for the same thing at the
// same moment may both make it, and one copy is kept.

#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "core/base/job_context.h"
#include "core/base/result.h"
#include "core/fit/fit_options.h"
#include "core/fit/pixel_solver.h"
#include "core/fit/table/table_search.h"
#include "core/neural/chromophore_network.h"
#include "core/rig/rig.h"
#include "core/skin/model/skin_model.h"
#include "core/skin/response_model.h"
#include "core/skin/response_table.h"

namespace cutis {

// How a program speaks of networks that are missing, or that are of another rig or profile.
struct NetworkAdvice {
  std::string missingPlace;   // where the error is: "--method"; empty: nowhere
  std::string mismatchPlace;  // "--weights"
  // What to do for this profile and rig: "train one with …"; none: to train one.
  std::function<std::string(const Profile&, const Rig&)> whatToDo;
};

class Engine {
 public:
  // cache: folder for what can be computed again; empty for none.
  explicit Engine(std::filesystem::path cache, NetworkAdvice advice = {});

  // A built-in profile or a file. `place` stands in front of errors about the name.
  Result<std::shared_ptr<const SkinModel>> model(const std::string& profile,
                                                 const std::string& place);
  // The model of the JSON text that maps carry.
  Result<std::shared_ptr<const SkinModel>> modelFromText(const std::string& text,
                                                         const std::string& place);

  // The method network takes the network of the options, or else that of network(); fails with the
  // advice if it is of another rig or profile, or there is none.
  Result<std::shared_ptr<const PixelSolver>> solver(const std::shared_ptr<const SkinModel>& model,
                                                    const Rig& rig, const FitOptions& options,
                                                    const JobContext& context);

  // The network for the channels of a rig and a profile: the last one added, or else the one that
  // travels inside the program; null if there is none. Some milliseconds.
  Result<std::shared_ptr<const ChromophoreNetwork>> network(const Profile& profile,
                                                            const Rig& rig) const;
  // Precondition: the network passed validate().
  void addNetwork(std::shared_ptr<const ChromophoreNetwork> network);

  // The response of a model's skin to rows of a response matrix (src/app/picture_request.h), for
  // maps that bring this along: with constants it takes some seconds where it is new.
  Result<std::shared_ptr<const ResponseModel>> response(
      const std::shared_ptr<const SkinModel>& model, const SpectrumRows& rows,
      const PerPixel& perPixel, const JobContext& context);

  // The table of a response that this engine made, for pictures while a control moves; null where
  // constants are free, which a table cannot hold.
  std::shared_ptr<const ResponseTable> responseTable(
      const std::shared_ptr<const ResponseModel>& response, const ParameterAxes& ranges);

  // The search in the table of skin for a rig.
  Result<std::shared_ptr<const TableSearch>> tableSearch(const SkinModel& model, const Rig& rig,
                                                         const JobContext& context);

 private:
  template <typename T>
  using Cache = std::map<std::string, std::shared_ptr<const T>>;

  template <typename T>
  std::shared_ptr<const T> find(const Cache<T>& cache, const std::string& key) const;
  template <typename T>
  std::shared_ptr<const T> keep(Cache<T>& cache, const std::string& key,
                                std::shared_ptr<const T> made);

  Result<std::shared_ptr<const PixelSolver>> networkSolver(
      const SkinModel& model, const Rig& rig,
      std::shared_ptr<const ChromophoreNetwork> given) const;

  std::string whatToDo(const Profile& profile, const Rig& rig) const;

  std::filesystem::path cache_;
  NetworkAdvice advice_;
  mutable std::mutex mutex_;
  Cache<SkinModel> models_;
  Cache<TableSearch> searches_;
  Cache<ResponseModel> responses_;
  std::map<const ResponseModel*, std::shared_ptr<const ResponseTable>> responseTables_;
  std::vector<std::shared_ptr<const ChromophoreNetwork>> networks_;  // those added
};

}  // namespace cutis
