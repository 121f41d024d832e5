#pragma once

// The error protocol of FITTING.md, run: methods at all noises, the bound, coverage, and what
// changes with lights, parameters and file formats. Fills the figures; deterministic but for times.

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "core/evaluate/error_metrics.h"
#include "src/cli/commands/bench/bench_figures.h"

namespace cutis {

inline constexpr std::array<double, 5> kBenchNoises = {0.0, 0.001, 0.002, 0.005, 0.01};
// Where a single noise must do: the built-in rigs' own.
inline constexpr double kUsualNoise = 0.005;

// People of the protocol, the same in all its parts.
std::vector<ParameterVector> benchPeople(std::size_t count);

struct BenchSubject {
  std::shared_ptr<const SkinModel> model;
  Rig rig;
  std::shared_ptr<const ErrorMeter> meter;
  std::size_t pixels = 20000;
  std::size_t subsample = 2000;  // of the exhaustive searches
  double timingSeconds = 0.3;    // per method and noise
};

// The parts of the protocol, each of which fills what it is named after.

Status runBounds(const BenchSubject& subject, const JobContext& context, BenchFigures& figures);
// And speedRatio. Relates to the bounds that are there.
Status runMethods(const BenchSubject& subject, BenchSolvers& solvers, const JobContext& context,
                  BenchFigures& figures);
// At kUsualNoise.
Status runSample(const BenchSubject& subject, Session& session, BenchSolvers& solvers,
                 const JobContext& context, BenchFigures& figures);

Status runCoverage(const BenchSubject& subject, BenchSolvers& solvers, const JobContext& context,
                   BenchFigures& figures);
// White light alone against all lights: the paper's Fig. 12. Nothing for a rig without.
Status runLights(const BenchSubject& subject, Session& session, const JobContext& context,
                 BenchFigures& figures);
// β-carotene held at 0 against all five parameters: the paper's Fig. 13.
Status runParameters(const BenchSubject& subject, BenchSolvers& solvers, const JobContext& context,
                     BenchFigures& figures);
// Where the refined fit begins.
Status runStarts(const BenchSubject& subject, BenchSolvers& solvers, const JobContext& context,
                 BenchFigures& figures);
Status runEncodings(const BenchSubject& subject, BenchSolvers& solvers, const JobContext& context,
                    BenchFigures& figures);

}  // namespace cutis
