#pragma once

// What the tests of networks share: a basis from a part of the table, and small trained networks.

#include "core/base/pixel_rows.h"
#include "core/neural/chromophore_network.h"
#include "core/neural/spectra_network.h"

namespace cutis::test {

// The basis of every 97th entry of the table of li2024.
const SpectraBasis& sampledBasis();

// A few seconds' worth of training: errors some ten times those of the defaults.
SpectraNetworkOptions quickSpectraOptions();
ChromophoreNetworkOptions quickChromophoreOptions();

// Trained with the quick options, for the monitor rig.
const SpectraNetwork& quickSpectraNetwork();
const ChromophoreNetwork& quickChromophoreNetwork();

// Columns of a matrix with one pixel a row.
PixelRows<const float> rowsOf(const Eigen::MatrixXf& pixels);
PixelRows<float> rowsOf(Eigen::MatrixXf& pixels);

}  // namespace cutis::test
