#include "src/bench/error_study.h"

#include <algorithm>
#include <span>
#include <utility>

#include "core/evaluate/error_protocol.h"
#include "core/simulate/skin_patch.h"

namespace cutis {
namespace {

constexpr std::uint64_t kPatchSeed = 1;
constexpr std::uint64_t kErrorNoiseSeed = 2;
constexpr std::size_t kMostBoundPeople = 4000;
constexpr int kSampleSize = 512;

// FITTING.md, for the monitor rig.
std::optional<double> printedBound(const Rig& rig, double noise) {
  constexpr std::array<std::pair<double, double>, 4> printed = {
      {{0.001, 7.6e-7}, {0.002, 1.4e-6}, {0.005, 3.8e-6}, {0.01, 9.7e-6}}};
  if (rig.name != "monitor") return {};
  for (const auto& [at, bound] : printed) {
    if (at == noise) return bound;
  }
  return {};
}

Result<MethodFigures> measureMethod(const BenchSubject& subject, const PixelSolver& solver,
                                    const ProtocolPixels& pixels, double noise,
                                    const JobContext& context) {
  const std::vector<float> channels = pixels.photograph(noise, kErrorNoiseSeed);
  CUTIS_TRY(solved,
            solveAll(solver, channels, pixels.count(), {false, subject.timingSeconds}, context));
  CUTIS_TRY(errors,
            subject.meter->measure(pixels.people(), solved.parameters, {context.stop, {}, {}}));
  MethodFigures figures;
  figures.noise = noise;
  figures.errors = summarise(errors);
  std::array<std::vector<PixelError>, kToneCount> byTone;
  for (const PixelError& error : errors)
    byTone[static_cast<std::size_t>(toneOf(error.typologyAngle))].push_back(error);
  for (std::size_t tone = 0; tone < byTone.size(); ++tone)
    figures.tones[tone] = summarise(byTone[tone]);
  figures.nanosecondsPerPixel = solved.nanosecondsPerPixel;
  figures.meanIterations = solved.meanIterations;
  figures.unconvergedShare = solved.unconvergedShare;
  return figures;
}

// Every noise for every method; the exhaustive searches look at a part of the pixels only.
Status measureMethods(const BenchSubject& subject, const ProtocolPixels& all,
                      const ProtocolPixels& part, std::span<const double> noises,
                      MethodSolvers& solvers, const JobContext& context,
                      std::vector<MethodFigures>& out) {
  const auto steps = static_cast<double>(kBenchMethods.size() * noises.size());
  double step = 0.0;
  for (const BenchMethod method : kBenchMethods) {
    for (const double noise : noises) {
      context.progress.report(step++ / steps);
      if (!isJudgedAt(method, noise) || !solvers.has(method)) continue;
      CUTIS_TRY(solver, solvers.solver(method, noise));
      CUTIS_TRY(figures,
                measureMethod(subject, *solver, isExhaustive(method) ? part : all, noise, context));
      figures.method = method;
      out.push_back(figures);
    }
  }
  return {};
}

void relateToBound(BenchFigures& figures) {
  for (MethodFigures& method : figures.methods) {
    for (const BoundFigures& bound : figures.bounds) {
      if (bound.noise == method.noise)
        method.overBound = method.errors.visibleMse / bound.bound.visible;
    }
  }
  const auto* refined = figuresOf(figures.methods, BenchMethod::refinedWide, kUsualNoise);
  const auto* searched = figuresOf(figures.methods, BenchMethod::threeStageExhaustive, kUsualNoise);
  if (refined != nullptr && searched != nullptr)
    figures.speedRatio = searched->nanosecondsPerPixel / refined->nanosecondsPerPixel;
}

// Skin of the sample, spread evenly over it.
Result<std::vector<ParameterVector>> samplePeople(const BenchSubject& subject,
                                                  const JobContext& context) {
  CUTIS_TRY(skin,
            simulateSkin(SkinRecipe(), kSampleSize, kSampleSize, kPatchSeed,
                         subject.model->profile().axes, subject.store, {context.stop, {}, {}}));
  const Rect all = skin.maps.state.bounds();
  std::array<std::vector<float>, kParameterCount> values;
  for (std::size_t k = 0; k < values.size(); ++k) {
    values[k].resize(all.pixelCount());
    CUTIS_CHECK(skin.maps.values[k].load(all, values[k]));
  }
  std::vector<float> states(all.pixelCount());
  CUTIS_CHECK(skin.maps.state.load(all, states));
  std::vector<ParameterVector> people;
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (states[i] != 0.0f) continue;
    ParameterVector person;
    for (std::size_t k = 0; k < values.size(); ++k)
      person[static_cast<Eigen::Index>(k)] = double{values[k][i]};
    people.push_back(person);
  }
  const std::size_t wanted = std::min(subject.pixels, people.size());
  for (std::size_t i = 0; i < wanted; ++i)
    people[i] = people[i * people.size() / wanted];
  people.resize(wanted);
  return people;
}

std::vector<ParameterVector> firstOf(const std::vector<ParameterVector>& people,
                                     std::size_t count) {
  return {people.begin(),
          people.begin() + static_cast<std::ptrdiff_t>(std::min(count, people.size()))};
}

}  // namespace

Status runBounds(const BenchSubject& subject, const JobContext& context, BenchFigures& figures) {
  const std::span<const double> noises = std::span(kBenchNoises).subspan(1);
  const auto people = firstOf(benchPeople(subject.pixels), kMostBoundPeople);
  CUTIS_TRY(bounds, errorBounds(*subject.model, subject.rig, people, priorOf(protocolPopulation()),
                                noises, context));
  for (std::size_t i = 0; i < noises.size(); ++i)
    figures.bounds.push_back({noises[i], bounds[i], printedBound(subject.rig, noises[i])});
  return {};
}

Status runMethods(const BenchSubject& subject, MethodSolvers& solvers, const JobContext& context,
                  BenchFigures& figures) {
  const JobContext silent = {context.stop, {}, {}};
  const auto people = benchPeople(subject.pixels);
  CUTIS_TRY(all, ProtocolPixels::create(*subject.model, subject.rig, people, silent));
  CUTIS_TRY(part, ProtocolPixels::create(*subject.model, subject.rig,
                                         firstOf(people, subject.subsample), silent));
  CUTIS_CHECK(measureMethods(subject, all, part, kBenchNoises, solvers, context, figures.methods));
  relateToBound(figures);
  return {};
}

Status runSample(const BenchSubject& subject, MethodSolvers& solvers, const JobContext& context,
                 BenchFigures& figures) {
  const JobContext silent = {context.stop, {}, {}};
  CUTIS_TRY(skin, samplePeople(subject, silent));
  CUTIS_TRY(sample, ProtocolPixels::create(*subject.model, subject.rig, skin, silent));
  // Not the first ones: these are the patch's upper edge.
  std::vector<ParameterVector> spread;
  const std::size_t wanted = std::min(subject.subsample, skin.size());
  for (std::size_t i = 0; i < wanted; ++i)
    spread.push_back(skin[i * skin.size() / wanted]);
  CUTIS_TRY(part, ProtocolPixels::create(*subject.model, subject.rig, spread, silent));
  return measureMethods(subject, sample, part, std::span(&kUsualNoise, 1), solvers, context,
                        figures.sample);
}

}  // namespace cutis
