#pragma once

// weights.json: both networks of a rig and a profile (core/neural), and what made them.
//
//   cutis_network   1
//   rig, profile    their names
//   command         the words after cutis-cli that make this file again, without the name of the
//                   output
//   spectra_nn      SpectraNN:
//                     trained     options: hidden, activation, components, truncation_error,
//                                 people {count, face_share, seed}, trainer {rate, weight_decay,
//                                 warm_up, epochs, batch, held_out_share, patience, seed}
//                     profile     signatureOf() the profile, core/spectra/signature.h
//                     axes        of the parameters: {maximum, samples, exponent} five times
//                     mean        of the spectra, reflectance at the 351 wavelengths of the grid
//                     components  one list of 351 numbers each
//                     layers      {inputs, outputs, activation, weights, bias} each; weights of
//                                 the first output first
//   chrom_nn        ChromNN: trained (noise [read, proportional] instead of components and
//                   truncation_error), profile, inputs (their names), channels (signatureOf()
//                   them), axes, layers
//
// Numbers of networks, mean and components are floats in the shortest form that reads back as the
// same float: the same networks make the same bytes. A file of the built-in size has some 130 kB.

#include <string>
#include <string_view>
#include <vector>

#include "core/base/result.h"
#include "core/neural/chromophore_network.h"
#include "core/neural/spectra_network.h"
#include "core/skin/profile/profile.h"

namespace cutis {

struct NetworkFile {
  std::string rig;
  std::string profile;
  std::string command;
  SpectraNetworkOptions spectraOptions;
  ChromophoreNetworkOptions chromophoreOptions;
  SpectraNetwork spectra;
  ChromophoreNetwork chromophores;
};

// Mean and components are rounded to float. Preconditions: the networks pass validate(), seeds are
// below 2³¹.
std::string networkText(const NetworkFile& file);
Status writeNetworks(const std::string& path, const NetworkFile& file);

// Everything is checked: options, sizes, finite numbers that fit a float, networks of one profile
// with one set of axes. Errors name the place and the field.
Result<NetworkFile> parseNetworks(std::string_view text, const std::string& place);
Result<NetworkFile> readNetworks(const std::string& path);

// Names of those that travel inside the program: "monitor-white_li2024", the rig, what of it, and
// the profile.
std::vector<std::string> builtInNetworkNames();
Result<NetworkFile> builtInNetworks(const std::string& name);

// Built-in ones, or a file. "monitor-5" stands for those that were trained for the profile or for
// another with the same physics, as skin2026 has of skin2026b. `place` stands in front of errors
// about the name.
Result<NetworkFile> loadNetworks(const std::string& nameOrPath, const Profile& profile,
                                 const std::string& place);

}  // namespace cutis
