#include "core/fit/table/table_search.h"

#include <algorithm>
#include <cstddef>

#include <Eigen/Cholesky>

#include "core/fit/population.h"
#include "core/spectra/colorimetry.h"

namespace cutis {
namespace {

// Kernels read whole vectors past the last entry.
constexpr std::size_t kPadding = 16;
// Entries that stay in the cache while all queries pass over them.
constexpr std::size_t kChunk = 2048;

constexpr std::array<int, 5> kAllFeatures = {0, 1, 2, 3, 4};
constexpr std::array<int, 4> kWhiteAndBlue = {0, 1, 2, 3};
constexpr std::array<int, 4> kWhiteAndGreen = {0, 1, 2, 4};

std::span<const int> firstOf(std::span<const int> features, bool narrowband) {
  return narrowband ? features : features.first(3);
}

Eigen::Vector3d triple(const SkinTable& table, int firstChannel, std::size_t entry) {
  return {double{table.channel(firstChannel)[entry]},
          double{table.channel(firstChannel + 1)[entry]},
          double{table.channel(firstChannel + 2)[entry]}};
}

// Least squares over all entries; the sums run in entry order.
Eigen::Matrix3d fitCameraToXyz(const SkinTable& table, int xyzChannel) {
  Eigen::Matrix3d gram = Eigen::Matrix3d::Zero();
  Eigen::Matrix3d cross = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < table.size(); ++i) {
    const Eigen::Vector3d rgb = triple(table, 0, i);
    gram += rgb * rgb.transpose();
    cross += rgb * triple(table, xyzChannel, i).transpose();
  }
  return gram.ldlt().solve(cross).transpose();
}

}  // namespace

SpectrumRows searchTableRows(const Rig& rig, const Spectrum& daylight, const Sensor& observer) {
  const Eigen::MatrixXd search = searchChannels(rig).fromRig * responseRows(rig).matrix();
  SpectrumRows rows(search.rows() + 3, kSampleCount);
  rows.topRows(search.rows()) = search.array();
  rows.bottomRows(3) = tristimulusRows(daylight, observer);
  return rows;
}

TableSearch::TableSearch(std::shared_ptr<const SkinTable> table, const Rig& rig,
                         const Eigen::Vector3d& white)
    : table_(std::move(table)), channels_(searchChannels(rig)), white_(white) {
  const auto rowCount = static_cast<int>(channels_.fromRig.rows());
  cameraToXyz_ = fitCameraToXyz(*table_, rowCount);
  features_.assign(static_cast<std::size_t>(rowCount),
                   std::vector<float>(table_->size() + kPadding));
  for (std::size_t i = 0; i < table_->size(); ++i) {
    const Eigen::Vector3d lab = labFromXyz(cameraToXyz_ * triple(*table_, 0, i), white_);
    for (std::size_t k = 0; k < 3; ++k) {
      features_[k][i] = static_cast<float>(lab[static_cast<Eigen::Index>(k)]);
    }
    for (int k = 3; k < rowCount; ++k) {
      features_[static_cast<std::size_t>(k)][i] =
          static_cast<float>(lightness(double{table_->channel(k)[i]}));
    }
  }
}

SearchFeatures TableSearch::features(std::span<const double> channels) const {
  const Eigen::Map<const Eigen::VectorXd> measured(channels.data(),
                                                   static_cast<Eigen::Index>(channels.size()));
  const Eigen::VectorXd search = channels_.fromRig * measured;
  const Eigen::Vector3d lab = labFromXyz(cameraToXyz_ * search.head<3>(), white_);
  SearchFeatures features = {static_cast<float>(lab[0]), static_cast<float>(lab[1]),
                             static_cast<float>(lab[2])};
  for (Eigen::Index k = 3; k < search.size(); ++k) {
    features[static_cast<std::size_t>(k)] = static_cast<float>(lightness(search[k]));
  }
  return features;
}

NearestArguments TableSearch::argumentsFor(const SearchFeatures& query,
                                           std::span<const int> features) const {
  NearestArguments arguments = {};
  arguments.featureCount = static_cast<int>(features.size());
  for (std::size_t f = 0; f < features.size(); ++f) {
    const auto feature = static_cast<std::size_t>(features[f]);
    arguments.features[f] = features_[feature].data();
    arguments.query[f] = query[feature];
  }
  arguments.blockCount = 1;
  return arguments;
}

void TableSearch::fullSearch(std::span<const SearchFeatures> queries,
                             std::span<std::size_t> entries) const {
  std::vector<Nearest> best(queries.size());
  for (std::size_t begin = 0; begin < table_->size(); begin += kChunk) {
    for (std::size_t q = 0; q < queries.size(); ++q) {
      NearestArguments arguments = argumentsFor(queries[q], fullFeatures());
      arguments.first = begin;
      arguments.blockSize = std::min(kChunk, table_->size() - begin);
      best[q] = nearestOf(arguments, best[q]);
    }
  }
  for (std::size_t q = 0; q < queries.size(); ++q)
    entries[q] = best[q].index;
}

std::size_t TableSearch::sampleCount(Parameter parameter) const {
  return static_cast<std::size_t>(table_->axes()[static_cast<std::size_t>(parameter)].samples);
}

std::size_t TableSearch::threeStage(const SearchFeatures& query, int caroteneSample) const {
  return laterStages(query, firstStage(query, caroteneSample));
}

std::size_t TableSearch::firstStage(const SearchFeatures& query, int caroteneSample) const {
  const std::size_t haemoglobins =
      sampleCount(kHaemoglobinDermal) * sampleCount(kHaemoglobinEpidermal);
  NearestArguments arguments = argumentsFor(query, firstStageFeatures());
  arguments.first = static_cast<std::size_t>(caroteneSample) * haemoglobins;
  arguments.blockSize = haemoglobins;
  arguments.blockStride = haemoglobins * sampleCount(kCarotene);
  arguments.blockCount = sampleCount(kMelanin) * sampleCount(kMelaninBlend);
  return nearestOf(arguments, {}).index;
}

std::size_t TableSearch::laterStages(const SearchFeatures& query, std::size_t firstEntry) const {
  const std::size_t haemoglobins =
      sampleCount(kHaemoglobinDermal) * sampleCount(kHaemoglobinEpidermal);
  const std::size_t perMelanin = haemoglobins * sampleCount(kCarotene);
  NearestArguments arguments = argumentsFor(query, firstStageFeatures());
  arguments.first = firstEntry / perMelanin * perMelanin;
  arguments.blockSize = perMelanin;
  const std::size_t carotene = nearestOf(arguments, {}).index / haemoglobins * haemoglobins;

  arguments = argumentsFor(query, firstOf(kWhiteAndGreen, hasNarrowband()));
  arguments.first = carotene;
  arguments.blockSize = haemoglobins;
  return nearestOf(arguments, {}).index;
}

std::span<const int> TableSearch::fullFeatures() const {
  return firstOf(kAllFeatures, hasNarrowband());
}

std::span<const int> TableSearch::firstStageFeatures() const {
  return firstOf(kWhiteAndBlue, hasNarrowband());
}

std::span<const float> TableSearch::featureOfEntries(int feature) const {
  return std::span(features_[static_cast<std::size_t>(feature)]).first(table_->size());
}

int TableSearch::mostFrequentCarotene(const SkinModel& model, const Rig& rig, int count) const {
  constexpr unsigned long long kTrainingSeed = 2024;
  const SpectrumRows rows = responseRows(rig);
  std::vector<SearchFeatures> queries;
  for (const ParameterVector& p : drawPopulation(protocolPopulation(), count, kTrainingSeed)) {
    const Eigen::VectorXd channels = rows.matrix() * model.reflectance(p).matrix();
    queries.push_back(features({channels.data(), static_cast<std::size_t>(channels.size())}));
  }
  std::vector<std::size_t> entries(queries.size());
  fullSearch(queries, entries);
  std::vector<int> votes(static_cast<std::size_t>(table_->axes()[kCarotene].samples), 0);
  for (const std::size_t entry : entries) {
    ++votes[static_cast<std::size_t>(table_->samples(entry)[kCarotene])];
  }
  return static_cast<int>(std::max_element(votes.begin(), votes.end()) - votes.begin());
}

}  // namespace cutis
