#include "src/bench/discrepancy_study.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <Eigen/Cholesky>

#include "core/base/parallel.h"
#include "core/base/random.h"
#include "core/fit/coefficient_line.h"
#include "core/fit/population.h"
#include "core/fit/spectrum_posterior.h"
#include "core/spectra/grid.h"

namespace cutis {
namespace {

constexpr std::uint64_t kDiscrepancySeed = 5;

// Somebody whose parameters, coefficients and rest are drawn from the discrepancy.
struct Person {
  std::vector<double> values;  // parameters, then coefficients
  Spectrum reflectance;
};

Eigen::VectorXd normals(Eigen::Index count, Random& random) {
  Eigen::VectorXd drawn(count);
  for (double& value : drawn)
    value = random.normal();
  return drawn;
}

std::vector<Person> drawPeople(const SkinModel& model, const Discrepancy& discrepancy,
                               std::size_t count) {
  const ParameterAxes& axes = model.profile().axes;
  const CoordinatePrior coordinates = coordinatePrior(discrepancy.prior, axes, {});
  const CoefficientLine line = coefficientLine(discrepancy, coordinates);
  const Eigen::MatrixXd root = discrepancy.covariance.llt().matrixL();
  std::vector<Person> people;
  for (const ParameterVector& parameters :
       drawFromPrior(discrepancy.prior, axes, static_cast<int>(count), kDiscrepancySeed)) {
    Random random(kDiscrepancySeed, people.size());
    Eigen::VectorXd x(int{kParameterCount});
    for (int i = 0; i < kParameterCount; ++i)
      x[i] = coordinates.coordinate(i, parameters[i]);
    const Eigen::VectorXd z = line.offset + line.slope * x + root * normals(root.cols(), random);
    const Spectrum rest =
        (discrepancy.rest * normals(discrepancy.rest.cols(), random)).array() +
        discrepancy.independentDeviation * normals(int{kSampleCount}, random).array();
    Person person;
    person.values.assign(parameters.begin(), parameters.end());
    person.values.insert(person.values.end(), z.begin(), z.end());
    person.reflectance = model.reflectance(parameters) * (discrepancy.factor(z) + rest);
    people.push_back(std::move(person));
  }
  return people;
}

// Their channels, multiplied by normal noise: the same draws for all noises.
PixelBuffer<float> photograph(const std::vector<Person>& people, const SpectrumRows& rows,
                              double noise) {
  PixelBuffer<float> channels(static_cast<std::size_t>(rows.rows()), people.size());
  for (std::size_t p = 0; p < people.size(); ++p) {
    Random random(kDiscrepancySeed + 1, p);
    const Eigen::VectorXd exact = rows.matrix() * people[p].reflectance.matrix();
    for (std::size_t k = 0; k < channels.rowCount(); ++k) {
      const double channel = exact[static_cast<Eigen::Index>(k)] * (1.0 + noise * random.normal());
      channels[k][p] = static_cast<float>(std::max(0.0, channel));
    }
  }
  return channels;
}

std::vector<double> columnOf(const PixelBuffer<float>& rows, std::size_t pixel) {
  std::vector<double> column;
  for (std::size_t k = 0; k < rows.rowCount(); ++k)
    column.push_back(double{rows[k][pixel]});
  return column;
}

ErrorBound byBand(const Spectrum& squares) {
  const auto mean = [&](const Band& band) {
    return squares.segment(band.first, band.count()).mean();
  };
  return {mean(kVisibleBand), mean(kUltravioletBand), mean(kNearInfraredBand)};
}

Result<DiscrepancyFigures> measure(const BenchSubject& subject, const std::vector<Person>& people,
                                   double noise, const JobContext& context) {
  FitOptions options;
  options.noise = NoiseModel{0.0, noise};
  options.discrepancy = true;
  CUTIS_TRY(solver, subject.engine.solver(subject.model, subject.rig, options, context));
  const PixelBuffer<float> channels = photograph(people, responseRows(subject.rig), noise);
  PixelBuffer<float> values(solver->valueCount(), people.size());
  std::vector<PixelState> states(people.size());
  std::vector<std::uint16_t> iterations(people.size());
  solver->solve(channels.rows(), values.rows(), {states.data(), iterations.data()});
  const SpectrumPosterior posterior(*subject.model, subject.rig, options);
  std::vector<Spectrum> errors(people.size()), bounds(people.size());
  CUTIS_CHECK(parallelFor(people.size(), context, [&](std::size_t p) -> Status {
    const Person& person = people[p];
    errors[p] = (posterior.reflectance(columnOf(values, p)) - person.reflectance).square();
    bounds[p] = posterior.deviation(posterior.channels(person.values), person.values).square();
    return {};
  }));
  Spectrum error = Spectrum::Zero(), bound = Spectrum::Zero();
  for (std::size_t p = 0; p < people.size(); ++p) {
    error += errors[p] / static_cast<double>(people.size());
    bound += bounds[p] / static_cast<double>(people.size());
  }
  const ErrorBound reached = byBand(error), least = byBand(bound);
  return DiscrepancyFigures{noise, reached, least, reached.visible / least.visible};
}

}  // namespace

Status runDiscrepancy(const BenchSubject& subject, const JobContext& context,
                      BenchFigures& figures) {
  const Discrepancy* discrepancy =
      subject.model->profile().discrepancies.of(SurfaceLight::included);
  if (discrepancy == nullptr) return {};
  const auto people = drawPeople(*subject.model, *discrepancy, subject.subsample);
  for (const double noise : std::span(kBenchNoises).subspan(1)) {
    CUTIS_TRY(row, measure(subject, people, noise, {context.stop, {}, {}}));
    figures.discrepancy.push_back(row);
  }
  return {};
}

}  // namespace cutis
