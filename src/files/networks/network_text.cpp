// Writing of src/files/networks/network_file.h.

#include <nlohmann/json.hpp>

#include "src/files/io/atomic_write.h"
#include "src/files/networks/network_file.h"
#include "src/files/networks/network_parts.h"

namespace cutis {
namespace {

using Json = nlohmann::ordered_json;

// The text of any column of doubles, rounded to float.
template <typename Column>
std::string roundedText(const Column& values) {
  std::vector<float> floats;
  for (const double value : values)
    floats.push_back(static_cast<float>(value));
  return floatsText(floats);
}

std::string axesText(const ParameterAxes& axes) {
  Json list = Json::array();
  for (const ParameterAxis& axis : axes) {
    list.push_back(
        {{"maximum", axis.maximum}, {"samples", axis.samples}, {"exponent", axis.exponent}});
  }
  return list.dump();
}

std::string componentsText(const Eigen::MatrixXd& components) {
  std::string text;
  for (Eigen::Index k = 0; k < components.cols(); ++k) {
    text += (text.empty() ? "[\n" : ",\n") + roundedText(components.col(k));
  }
  return text + "]";
}

std::string spectraText(const NetworkFile& file) {
  return "{\n\"trained\":" + optionsText(file.spectraOptions) +
         ",\n\"profile\":" + floatsText(file.spectra.profile) +
         ",\n\"axes\":" + axesText(file.spectra.axes) +
         ",\n\"mean\":" + roundedText(file.spectra.mean) +
         ",\n\"components\":" + componentsText(file.spectra.components) +
         ",\n\"layers\":" + layersText(file.spectra.network) + "}";
}

std::string chromophoresText(const NetworkFile& file) {
  const ChromophoreNetwork& network = file.chromophores;
  return "{\n\"trained\":" + optionsText(file.chromophoreOptions) +
         ",\n\"profile\":" + floatsText(network.profile) +
         ",\n\"inputs\":" + jsonText(network.inputs) +
         ",\n\"channels\":" + floatsText(network.channels) +
         ",\n\"axes\":" + axesText(network.axes) + ",\n\"layers\":" + layersText(network.network) +
         "}";
}

}  // namespace

std::string networkText(const NetworkFile& file) {
  return "{\n\"cutis_network\":1,\n\"rig\":" + jsonText(file.rig) +
         ",\n\"profile\":" + jsonText(file.profile) + ",\n\"command\":" + jsonText(file.command) +
         ",\n\"spectra_nn\":" + spectraText(file) + ",\n\"chrom_nn\":" + chromophoresText(file) +
         "\n}\n";
}

Status writeNetworks(const std::string& path, const NetworkFile& file) {
  return writeTextAtomically(path, networkText(file));
}

}  // namespace cutis
