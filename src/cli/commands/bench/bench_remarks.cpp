#include "src/cli/commands/bench/bench_remarks.h"

#include "core/base/number_text.h"

namespace cutis {
namespace {

// "refined fit 1.5e-6 → 3.8e-6"; empty where it was not measured.
std::string change(const BenchFigures& figures, BenchMethod method, const char* name) {
  const auto* without = figuresOf(figures.methods, method, 0.0);
  const auto* with = figuresOf(figures.methods, method, kUsualNoise);
  if (without == nullptr || with == nullptr) return {};
  return std::string(name) + " " + shortScientific(without->errors.visibleMse) + " → " +
         shortScientific(with->errors.visibleMse);
}

// What the network makes of more noise than it has seen; empty where it was not measured.
std::string networkInMuchNoise(const BenchFigures& figures) {
  const double most = kBenchNoises.back();
  const auto* network = figuresOf(figures.methods, BenchMethod::network, most);
  const auto* refined = figuresOf(figures.methods, BenchMethod::refinedWide, most);
  if (network == nullptr || refined == nullptr) return {};
  return "The network learned from the rig's noise; at " + percentText(most, 2) + " it leaves " +
         fixedNumber(network->errors.visibleMse / refined->errors.visibleMse, 1) +
         " times what the fit leaves. ";
}

std::string joined(const std::vector<std::string>& parts) {
  std::string text;
  for (const std::string& part : parts) {
    if (!part.empty()) text += (text.empty() ? "" : ", ") + part;
  }
  return text;
}

}  // namespace

std::vector<std::string> noiseRemarks(const BenchFigures& figures) {
  const std::string changes = joined({change(figures, BenchMethod::refinedWide, "refined fit"),
                                      change(figures, BenchMethod::network, "network"),
                                      change(figures, BenchMethod::threeStage, "three stages"),
                                      change(figures, BenchMethod::fullSearch, "full search")});
  if (changes.empty()) return {};
  return {"Mean squared error without noise → with 0.5 %: " + changes + ".",
          "Without noise the refined fit still assumes the rig's and leans on its prior. " +
              networkInMuchNoise(figures) + "Searches are held up by the steps of their table.",
          "The paper's 3e-8 for its network is without noise, on the paper's own population and "
          "protocol: not to be compared digit by digit."};
}

}  // namespace cutis
