#pragma once

// What files of networks and of trainings have in common, as JSON.
//
// Floats are written in the shortest form that reads back as the same float. Errors of readers name
// the file and the field.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "core/base/result.h"
#include "core/neural/chromophore_network.h"
#include "core/neural/spectra_network.h"
#include "src/files/io/json_file.h"

namespace cutis {

// "[0.5,-1e-9]"
std::string floatsText(std::span<const float> values);
// The JSON of a text or of several.
std::string jsonText(const nlohmann::ordered_json& text);
std::string layersText(const DenseNetwork& network);
// All options that a network was trained with. Precondition: seeds are below 2³¹.
std::string optionsText(const SpectraNetworkOptions& options);
std::string optionsText(const ChromophoreNetworkOptions& options);

Result<int> wholeNumber(const JsonValue& object, const std::string& key, int least, int most);
// Finite numbers, as many as `count`, that fit a float.
Result<std::vector<float>> asFloats(const JsonValue& list, std::size_t count);
Result<std::vector<float>> floats(const JsonValue& object, const std::string& key,
                                  std::size_t count);
Result<Activation> activationOf(const JsonValue& object);
// Each layer on its own is sound; validate() says whether they fit together.
Result<DenseNetwork> parseLayers(const JsonValue& object, const std::string& key);

}  // namespace cutis
