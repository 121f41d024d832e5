#include "src/cli/commands/train/train_report.h"

#include <array>

#include "core/base/number_text.h"
#include "src/cli/text_table.h"

namespace cutis {
namespace {

constexpr std::array kComponentCounts = {1, 2, 4, 6, 8, 10, 12, 14, 16, 18, 20, 24};

std::string sizes(const TrainedNetworks& trained) {
  TextTable table({"", ""});
  table.add({"components", std::to_string(trained.components())});
  table.add(
      {"weights of SpectraNN", std::to_string(trained.file.spectra.network.parameterCount())});
  table.add(
      {"weights of ChromNN", std::to_string(trained.file.chromophores.network.parameterCount())});
  table.add({"epochs of SpectraNN", std::to_string(trained.spectraCurve.size())});
  table.add({"epochs of ChromNN", std::to_string(trained.chromophoreCurve.size())});
  table.add({"seconds", fixedNumber(trained.seconds, 1)});
  return table.text().substr(1);
}

std::string truncation(const TrainedNetworks& trained) {
  TextTable table({"components", "error left"}, 0);
  bool shown = false;
  const int used = trained.components();
  const auto add = [&](int count, const char* mark) {
    table.add(
        {mark + std::to_string(count), shortScientific(trained.basis.truncationError(count))});
  };
  for (const int count : kComponentCounts) {
    if (!shown && count >= used) {
      add(used, "used: ");
      shown = true;
    }
    if (count != used) add(count, "");
  }
  if (!shown) add(used, "used: ");
  return "  principal components: mean squared error of spectra, 300-1000 nm, over the table\n" +
         table.text();
}

std::string accuracy(const NetworkErrors& errors) {
  TextTable table({"mean squared error, 400-700 nm", "no noise", "the rig's noise"});
  table.add({"SpectraNN", shortScientific(errors.decoded), "-"});
  table.add({"ChromNN and the skin model", shortScientific(errors.encoded),
             shortScientific(errors.encodedNoisy)});
  table.add(
      {"ChromNN and SpectraNN", shortScientific(errors.both), shortScientific(errors.bothNoisy)});
  return table.text();
}

}  // namespace

std::string trainReport(const TrainedNetworks& trained, const NetworkErrors& errors) {
  return sizes(trained) + "\n" + truncation(trained) + "\n" + accuracy(errors);
}

}  // namespace cutis
