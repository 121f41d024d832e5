#include "src/app/engine.h"

#include <algorithm>
#include <utility>

#include "core/base/content_hash.h"
#include "core/base/echoed_text.h"
#include "core/fit/free/free_solver.h"
#include "core/fit/network_solver.h"
#include "core/fit/refined/refined_solver.h"
#include "core/fit/table/search_solver.h"
#include "core/skin/profile/profile_signature.h"
#include "src/files/networks/network_file.h"
#include "src/files/profiles/layer_table_cache.h"
#include "src/files/profiles/profile_file.h"
#include "src/files/profiles/table_cache.h"
#include "src/files/spectral_library.h"

namespace cutis {
namespace {

// Simulated faces that decide what the first stage of the three-stage search holds fixed.
constexpr int kTrainingPopulation = 1000;

}  // namespace

Engine::Engine(std::filesystem::path cache, NetworkAdvice advice)
    : cache_(std::move(cache)), advice_(std::move(advice)) {}

std::string Engine::whatToDo(const Profile& profile, const Rig& rig) const {
  return advice_.whatToDo ? advice_.whatToDo(profile, rig) : "train one for them";
}

template <typename T>
std::shared_ptr<const T> Engine::find(const Cache<T>& cache, const std::string& key) const {
  const std::scoped_lock lock(mutex_);
  const auto found = cache.find(key);
  return found == cache.end() ? nullptr : found->second;
}

template <typename T>
std::shared_ptr<const T> Engine::keep(Cache<T>& cache, const std::string& key,
                                      std::shared_ptr<const T> made) {
  const std::scoped_lock lock(mutex_);
  return cache.try_emplace(key, std::move(made)).first->second;
}

Result<std::shared_ptr<const SkinModel>> Engine::model(const std::string& profile,
                                                       const std::string& place) {
  CUTIS_TRY(text, profileText(profile, place));
  return modelFromText(text, profile);
}

Result<std::shared_ptr<const SkinModel>> Engine::modelFromText(const std::string& text,
                                                               const std::string& place) {
  const std::string key = ContentHash().add(std::string_view(text)).digest();
  if (auto known = find(models_, key)) return known;
  CUTIS_TRY(profile, parseProfile(text, place));
  if (profile.layerOptics == LayerOpticsKind::diffusion) {
    return keep(models_, key, std::make_shared<const SkinModel>(profile));
  }
  CUTIS_TRY(table, cachedLayerTable(profile, cache_, {}));
  return keep(models_, key, std::make_shared<const SkinModel>(profile, std::move(table)));
}

Result<std::shared_ptr<const PixelSolver>> Engine::solver(
    const std::shared_ptr<const SkinModel>& model, const Rig& rig, const FitOptions& options,
    const JobContext& context) {
  CUTIS_CHECK(requireFive(model->profile(), "a fit of photographs"));
  if (options.free.count() > 0) {
    CUTIS_TRY(freeSolver, makeFreeSolver(model, rig, options, context));
    return std::shared_ptr<const PixelSolver>(std::move(freeSolver));
  }
  if (options.method == FitMethod::refined) {
    return std::shared_ptr<const PixelSolver>(makeRefinedSolver(model, rig, options));
  }
  if (options.method == FitMethod::network) return networkSolver(*model, rig, options.network);
  CUTIS_TRY(search, tableSearch(*model, rig, context.child(0.0, 0.8, "table of skin")));
  auto channels = std::make_shared<const ResponseModel>(*model, responseRows(rig));
  if (options.method == FitMethod::fullSearch) {
    return std::shared_ptr<const PixelSolver>(makeFullSearchSolver(search, std::move(channels)));
  }
  const int carotene = search->mostFrequentCarotene(*model, rig, kTrainingPopulation);
  return std::shared_ptr<const PixelSolver>(
      makeThreeStageSolver(search, carotene, std::move(channels)));
}

Result<std::shared_ptr<const PixelSolver>> Engine::networkSolver(
    const SkinModel& model, const Rig& rig, std::shared_ptr<const ChromophoreNetwork> given) const {
  if (given == nullptr) {
    CUTIS_TRY(found, network(model.profile(), rig));
    if (found == nullptr) {
      return inputError(advice_.missingPlace,
                        "no network is built in for rig " + inQuotes(rig.name) +
                            " with these lights and profile " + inQuotes(model.profile().name) +
                            "; " + whatToDo(model.profile(), rig));
    }
    given = found;
  }
  const auto channels = matchNetwork(*given, model.profile(), rig, advice_.mismatchPlace);
  if (channels.failed()) {
    const Error& mismatch = channels.error();
    return Error{mismatch.kind, mismatch.place,
                 mismatch.message + "; " + whatToDo(model.profile(), rig)};
  }
  return std::shared_ptr<const PixelSolver>(
      makeNetworkSolver(*given, channels.value(),
                        std::make_shared<const ResponseModel>(model, channels.value().rows)));
}

Result<std::shared_ptr<const ChromophoreNetwork>> Engine::network(const Profile& profile,
                                                                  const Rig& rig) const {
  const Signature wantedProfile = signatureOf(profile);
  const Signature wantedChannels = signatureOf(networkChannels(rig));
  const auto isWanted = [&](const ChromophoreNetwork& network) {
    return alike(network.profile, wantedProfile) && alike(network.channels, wantedChannels);
  };
  {
    const std::scoped_lock lock(mutex_);
    const auto added = std::find_if(networks_.rbegin(), networks_.rend(),
                                    [&](const auto& network) { return isWanted(*network); });
    if (added != networks_.rend()) return *added;
  }
  for (const std::string& name : builtInNetworkNames()) {
    CUTIS_TRY(file, builtInNetworks(name));
    if (isWanted(file.chromophores))
      return std::make_shared<const ChromophoreNetwork>(std::move(file.chromophores));
  }
  return std::shared_ptr<const ChromophoreNetwork>();
}

void Engine::addNetwork(std::shared_ptr<const ChromophoreNetwork> network) {
  const std::scoped_lock lock(mutex_);
  networks_.push_back(std::move(network));
}

Result<std::shared_ptr<const ResponseModel>> Engine::response(
    const std::shared_ptr<const SkinModel>& model, const SpectrumRows& rows,
    const PerPixel& perPixel, const JobContext& context) {
  ContentHash hash;
  hash.add(fingerprint(model->profile()));
  hash.add(std::span<const double>(rows.data(), static_cast<std::size_t>(rows.size())));
  hash.add(static_cast<double>(perPixel.free.oxygenation));
  hash.add(static_cast<double>(perPixel.free.thickness));
  if (const Discrepancy* discrepancy = discrepancyOf(model->profile(), perPixel)) {
    hash.add(std::span(discrepancy->mean.data(), static_cast<std::size_t>(kSampleCount)));
    hash.add(std::span(discrepancy->components.data(),
                       static_cast<std::size_t>(discrepancy->components.size())));
  }
  const std::string key = hash.digest();
  if (auto known = find(responses_, key)) return known;
  CUTIS_TRY(made, ResponseModel::create(*model, rows, perPixel, context));
  return keep(responses_, key, std::move(made));
}

std::shared_ptr<const ResponseTable> Engine::responseTable(
    const std::shared_ptr<const ResponseModel>& response, const ParameterAxes& ranges) {
  if (response == nullptr || response->free().count() > 0) return nullptr;
  {
    const std::scoped_lock lock(mutex_);
    const auto known = responseTables_.find(response.get());
    if (known != responseTables_.end()) return known->second;
  }
  auto made = std::make_shared<const ResponseTable>(*response, ranges);
  const std::scoped_lock lock(mutex_);
  return responseTables_.try_emplace(response.get(), std::move(made)).first->second;
}

Result<std::shared_ptr<const TableSearch>> Engine::tableSearch(const SkinModel& model,
                                                               const Rig& rig,
                                                               const JobContext& context) {
  const std::string key = fingerprint(model.profile()) + fingerprint(rig);
  if (auto known = find(searches_, key)) return known;
  CUTIS_TRY(daylight, loadLight({"D65", {}, {}}));
  CUTIS_TRY(observer, loadCamera({"cie1931", {}, {}}));
  const SpectrumRows rows = searchTableRows(rig, daylight, observer.sensor);
  CUTIS_TRY(table, cachedSkinTable(model, rows, cache_, context));
  return keep(
      searches_, key,
      std::make_shared<const TableSearch>(table, rig, whitePoint(daylight, observer.sensor)));
}

}  // namespace cutis
