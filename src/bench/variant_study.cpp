#include "src/bench/variant_study.h"

#include <span>
#include <string>

#include "core/evaluate/error_protocol.h"

namespace cutis {
namespace {

constexpr std::uint64_t kVariantNoiseSeed = 3;
constexpr std::uint64_t kPriorSeed = 4;
constexpr char kVariantWhite[] = "white";

// A population in front of a rig.
struct PhotographedPeople {
  const BenchSubject& subject;
  const ProtocolPixels& pixels;
  JobContext context;
};

Result<VariantFigures> measureVariant(const PhotographedPeople& people, const PixelSolver& solver,
                                      const std::string& name, double noise,
                                      SampleEncoding encoding = SampleEncoding::float32) {
  const auto channels = people.pixels.photograph(noise, kVariantNoiseSeed, encoding);
  CUTIS_TRY(solved, solveAll(solver, channels, people.pixels.count(), {}, people.context));
  CUTIS_TRY(errors, people.subject.meter->measure(people.pixels.people(), solved.parameters,
                                                  people.context));
  VariantFigures figures;
  figures.variant = name;
  figures.noise = noise;
  figures.errors = summarise(errors);
  return figures;
}

}  // namespace

Status runCoverage(const BenchSubject& subject, MethodSolvers& solvers, const JobContext& context,
                   BenchFigures& figures) {
  for (const BenchMethod method : {BenchMethod::refinedWide, BenchMethod::refinedPopulation}) {
    const bool wide = method == BenchMethod::refinedWide;
    const Profile& profile = subject.model->profile();
    const Prior prior = wide ? profile.prior : priorOf(protocolPopulation());
    CUTIS_TRY(pixels,
              ProtocolPixels::create(
                  *subject.model, subject.rig,
                  drawFromPrior(prior, profile.axes, static_cast<int>(subject.pixels), kPriorSeed),
                  context));
    CUTIS_TRY(solver, solvers.solver(method, kUsualNoise));
    const auto channels = pixels.photograph(kUsualNoise, kVariantNoiseSeed);
    CUTIS_TRY(solved, solveAll(*solver, channels, pixels.count(), {true, 0.0}, context));
    figures.coverage.push_back(
        {wide ? "wide" : "population", kUsualNoise,
         coverageOf(pixels.people(), solved.parameters, solved.deviations, prior)});
  }
  return {};
}

Status runLights(const BenchSubject& subject, const JobContext& context, BenchFigures& figures) {
  if (subject.rig.lightIndex(kVariantWhite) < 0) return {};
  CUTIS_TRY(white, withLights(subject.rig, {kVariantWhite}, "--rig"));
  const auto people = benchPeople(subject.pixels);
  const std::array<const Rig*, 2> rigs = {&subject.rig, &white};
  for (const Rig* rig : rigs) {
    CUTIS_TRY(pixels, ProtocolPixels::create(*subject.model, *rig, people, context));
    CUTIS_TRY(bounds,
              errorBounds(*subject.model, *rig, std::span(people).first(people.size() / 5),
                          priorOf(protocolPopulation()), std::span(&kUsualNoise, 1), context));
    MethodSolvers solvers(subject.engine, subject.model, *rig, context);
    for (const BenchMethod method : {BenchMethod::refinedWide, BenchMethod::refinedPopulation}) {
      CUTIS_TRY(solver, solvers.solver(method, kUsualNoise));
      const std::string name = std::to_string(rig->lights.size()) +
                               (rig->lights.size() == 1 ? " light, " : " lights, ") +
                               methodLabel(method);
      CUTIS_TRY(variant, measureVariant({subject, pixels, context}, *solver, name, kUsualNoise));
      variant.bound = bounds.front();
      figures.lights.push_back(variant);
    }
  }
  return {};
}

Status runParameters(const BenchSubject& subject, MethodSolvers& solvers, const JobContext& context,
                     BenchFigures& figures) {
  CUTIS_TRY(pixels, ProtocolPixels::create(*subject.model, subject.rig, benchPeople(subject.pixels),
                                           context));
  const PhotographedPeople photographed = {subject, pixels, context};
  for (const BenchMethod method : {BenchMethod::refinedWide, BenchMethod::refinedPopulation}) {
    for (const bool fixed : {false, true}) {
      CUTIS_TRY(solver, solvers.solver(method, kUsualNoise, fixed));
      const std::string name =
          std::string(fixed ? "four parameters, " : "five parameters, ") + methodLabel(method);
      CUTIS_TRY(variant, measureVariant(photographed, *solver, name, kUsualNoise));
      figures.parameters.push_back(variant);
    }
  }
  return {};
}

Status runEncodings(const BenchSubject& subject, MethodSolvers& solvers, const JobContext& context,
                    BenchFigures& figures) {
  struct Kind {
    const char* name;
    SampleEncoding encoding;
  };
  constexpr std::array<Kind, 4> kinds = {{{"8-bit, sRGB curve", SampleEncoding::srgb8},
                                          {"16-bit, linear", SampleEncoding::linear16},
                                          {"half", SampleEncoding::half},
                                          {"float", SampleEncoding::float32}}};
  CUTIS_TRY(pixels, ProtocolPixels::create(*subject.model, subject.rig, benchPeople(subject.pixels),
                                           context));
  const PhotographedPeople photographed = {subject, pixels, context};
  for (const double noise : {0.0, kUsualNoise}) {
    CUTIS_TRY(solver, solvers.solver(BenchMethod::refinedPopulation, noise));
    for (const Kind& kind : kinds) {
      CUTIS_TRY(variant, measureVariant(photographed, *solver, kind.name, noise, kind.encoding));
      figures.encodings.push_back(variant);
    }
  }
  return {};
}

}  // namespace cutis
