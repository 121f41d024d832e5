#include "tests/core/fit/fit_fixture.h"

#include <cmath>

#include <Eigen/LU>

#include "core/base/random.h"
#include "core/fit/population.h"
#include "tests/support/models.h"

namespace cutis::test {

std::shared_ptr<const SkinModel> sharedModel() {
  return {std::shared_ptr<const SkinModel>(), &li2024()};
}

std::shared_ptr<const SkinTable> monitorTable() {
  static const auto table = std::make_shared<const SkinTable>(
      buildSkinTable(li2024(), searchTableRows(monitorRig(), light("D65"), cie1931()), {}).value());
  return table;
}

std::shared_ptr<const TableSearch> monitorSearch() {
  static const auto search =
      std::make_shared<const TableSearch>(monitorTable(), monitorRig(), daylightWhite());
  return search;
}

Eigen::VectorXd PixelSet::at(std::size_t pixel) const {
  Eigen::VectorXd values(static_cast<Eigen::Index>(channelCount()));
  for (std::size_t k = 0; k < channelCount(); ++k) {
    values[static_cast<Eigen::Index>(k)] = double{channels[k * count + pixel]};
  }
  return values;
}

PixelSet simulate(const Rig& rig, const std::vector<ParameterVector>& people, double noise) {
  const SpectrumRows rows = responseRows(rig);
  Random random(99);
  PixelSet pixels;
  pixels.count = people.size();
  pixels.channels.resize(static_cast<std::size_t>(rows.rows()) * people.size());
  for (std::size_t i = 0; i < people.size(); ++i) {
    const Eigen::VectorXd values = rows.matrix() * li2024().reflectance(people[i]).matrix();
    for (Eigen::Index k = 0; k < values.size(); ++k) {
      const double measured = values[k] * (1.0 + noise * random.normal());
      pixels.channels[static_cast<std::size_t>(k) * people.size() + i] =
          static_cast<float>(measured);
    }
  }
  return pixels;
}

PixelSet pixelsOf(const std::vector<std::vector<float>>& pixels) {
  PixelSet set;
  set.count = pixels.size();
  set.channels.resize(pixels.size() * pixels.front().size());
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    for (std::size_t k = 0; k < pixels[i].size(); ++k) {
      set.channels[k * pixels.size() + i] = pixels[i][k];
    }
  }
  return set;
}

ParameterVector Solutions::at(std::size_t pixel) const {
  ParameterVector values;
  for (Eigen::Index k = 0; k < kParameterCount; ++k) {
    values[k] = double{parameters[static_cast<std::size_t>(k) * states.size() + pixel]};
  }
  return values;
}

Solutions solve(const PixelSolver& solver, const PixelSet& pixels) {
  Solutions solutions;
  solutions.parameters.resize(kParameterCount * pixels.count);
  solutions.states.resize(pixels.count, PixelState::masked);
  solutions.iterations.resize(pixels.count, 999);
  solver.solve(pixels.rows(),
               packedRows(solutions.parameters.data(), kParameterCount, pixels.count),
               {solutions.states.data(), solutions.iterations.data()});
  return solutions;
}

double visibleError(const ParameterVector& a, const ParameterVector& b) {
  double sum = 0.0;
  for (int i = kVisibleBand.first; i <= kVisibleBand.last; ++i) {
    const double difference = li2024().reflectanceAt(i, a) - li2024().reflectanceAt(i, b);
    sum += difference * difference;
  }
  return sum / kVisibleBand.count();
}

Prior populationPrior() {
  const ParameterBox box = protocolPopulation();
  return {PriorScale::linear, 0.5 * (box.low + box.high), (box.high - box.low) / std::sqrt(12.0)};
}

ParameterVector Objective::coordinates(const ParameterVector& parameters) const {
  ParameterVector x = parameters;
  for (int i = 0; i < kParameterCount; ++i) {
    if (prior && prior->isLog(i)) x[i] = std::log(parameters[i]);
  }
  return x;
}

ParameterVector Objective::parameters(const ParameterVector& coordinates) const {
  ParameterVector x = coordinates;
  for (int i = 0; i < kParameterCount; ++i) {
    if (prior && prior->isLog(i)) x[i] = std::exp(coordinates[i]);
  }
  return x;
}

Eigen::VectorXd Objective::modelled(const ParameterVector& parameters) const {
  Eigen::VectorXd reflectance(static_cast<Eigen::Index>(nodes.samples.size()));
  for (Eigen::Index n = 0; n < reflectance.size(); ++n) {
    reflectance[n] = model.reflectanceAt(nodes.samples[static_cast<std::size_t>(n)], parameters);
  }
  return nodes.weights * reflectance;
}

double Objective::cost(const Eigen::VectorXd& channels, const ParameterVector& parameters) const {
  const Eigen::VectorXd residual = channels - modelled(parameters);
  double sum = 0.0;
  for (Eigen::Index k = 0; k < residual.size(); ++k) {
    if (nodes.weights.row(k).isZero(0.0)) continue;
    const double deviation = std::hypot(noise.read, noise.proportional * channels[k]);
    sum += residual[k] * residual[k] / (deviation * deviation);
  }
  if (!prior) return sum;
  const ParameterVector away = (coordinates(parameters) - coordinates(prior->mean));
  return sum + (away / prior->deviation).square().sum();
}

Eigen::Matrix<double, 5, 5> Objective::covariance(const Eigen::VectorXd& channels,
                                                  const ParameterVector& at) const {
  const ParameterVector x = coordinates(at);
  Eigen::MatrixXd jacobian(channels.size(), kParameterCount);
  for (int i = 0; i < kParameterCount; ++i) {
    const double step = 1e-5 * std::max(std::abs(x[i]), 1e-3);
    ParameterVector above = x, below = x;
    above[i] += step;
    below[i] -= step;
    jacobian.col(i) = (modelled(parameters(above)) - modelled(parameters(below))) / (2.0 * step);
  }
  Eigen::Matrix<double, 5, 5> information = Eigen::Matrix<double, 5, 5>::Zero();
  for (Eigen::Index k = 0; k < channels.size(); ++k) {
    const double deviation = std::hypot(noise.read, noise.proportional * channels[k]);
    information += jacobian.row(k).transpose() * jacobian.row(k) / (deviation * deviation);
  }
  if (prior) information.diagonal() += prior->deviation.square().inverse().matrix();
  return information.inverse();
}

}  // namespace cutis::test
