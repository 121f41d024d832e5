#pragma once

// What several operations share and what takes time to prepare: compiled profiles, tables, solvers,
// reduced response matrices. The command line and the editor work through the same engine, so that
// the same input gives the same pixels.
//
// Thread-safe. What is asked for twice is made once; two threads that ask for the same thing at the
// same moment may both make it, and one copy is kept.

#include <filesystem>
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
#include "src/app/picture_request.h"

namespace cutis {

class Engine {
 public:
  // cache: folder for what can be computed again; empty for none.
  explicit Engine(std::filesystem::path cache);

  // A built-in profile or a file. `place` stands in front of errors about the name.
  Result<std::shared_ptr<const SkinModel>> model(const std::string& profile,
                                                 const std::string& place);
  // The model of the JSON text that maps carry.
  Result<std::shared_ptr<const SkinModel>> modelFromText(const std::string& text,
                                                         const std::string& place);

  // The method network takes the network of the options, or else that of network(); fails with the
  // command that trains one if it is of another rig or profile, or there is none.
  Result<std::shared_ptr<const PixelSolver>> solver(const std::shared_ptr<const SkinModel>& model,
                                                    const Rig& rig, const FitOptions& options,
                                                    const JobContext& context);

  // The network for the channels of a rig and a profile: the last one added, or else the one that
  // travels inside the program; null if there is none. Some milliseconds.
  Result<std::shared_ptr<const ChromophoreNetwork>> network(const Profile& profile,
                                                            const Rig& rig) const;
  // Precondition: the network passed validate().
  void addNetwork(std::shared_ptr<const ChromophoreNetwork> network);

  // A picture of the model's skin, of maps that bring along the constants that are `free`: then it
  // takes some seconds where it is new.
  Result<std::shared_ptr<const ResponseModel>> picture(
      const std::shared_ptr<const SkinModel>& model, const PictureRequest& request,
      const std::string& place, const FreeConstants& free = {}, const JobContext& context = {});

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

  std::filesystem::path cache_;
  mutable std::mutex mutex_;
  Cache<SkinModel> models_;
  Cache<TableSearch> searches_;
  Cache<ResponseModel> pictures_;
  std::vector<std::shared_ptr<const ChromophoreNetwork>> networks_;  // those added
};

}  // namespace cutis
