#pragma once

// The chromophores of skin: one row for each number that describes it, with all that is said of
// that number. Names, symbols, units, layers, absorptions, ranges, laws of editing and scales of
// the prior are written down here and read from here.
//
// The paper's five are Parameter (core/skin/profile/parameter.h). A profile may have further rows,
// made at run time (Profile::further): everything in double precision but the free constants knows
// them; the vectorised kernels know the five alone (core/skin/model/compiled_model.h).
//
// Thread-safe: the table is constant.

#include <array>
#include <functional>
#include <string>

#include "core/skin/profile/parameter.h"
#include "core/skin/profile/parameter_axis.h"
#include "core/spectra/grid.h"

namespace cutis {

struct Profile;

enum class SkinLayer { epidermis, dermis };

// What a factor s makes of an amount C (paper, §4.3).
enum class EditLaw {
  linear,   // C · s
  byIndex,  // C · (1 + (s − 1) · i/N), with i/N the place of C on its axis: local variation is
            // accentuated
};

// In what a prior is normal (core/skin/profile/prior.h).
enum class PriorScale {
  linear,  // mean and deviation in the parameter's own unit
  log,     // mean: the median, in the parameter's own unit; deviation: of its natural logarithm
};

struct Chromophore {
  std::string name;    // "melanin": in files and options
  std::string symbol;  // "C_m": in narrow labels
  std::string unit;    // of the number
  SkinLayer layer = SkinLayer::epidermis;
  // The absorption of a unit of it in that layer of a profile, net of the tissue it displaces;
  // mm⁻¹. May be negative where it absorbs less than that tissue.
  std::function<Spectrum(const Profile&)> absorption;
  // From 0. Of the five it is the paper's (Table 2); a profile has its own (Profile::axes).
  ParameterAxis range;
  EditLaw editLaw = EditLaw::linear;
  PriorScale priorScale = PriorScale::log;  // on the log scale; on the linear one all are linear
};

// Indexed by Parameter. Melanin is a mixture: its row is eumelanin, and that of its blend what
// stands in for the rest, pheomelanin.
const std::array<Chromophore, kParameterCount>& chromophoreTable();

// "melanin, melanin_blend, …": the names of all with something between them.
std::string parameterNames(const std::string& between);

// The ranges of the table.
ParameterAxes paperAxes();

}  // namespace cutis
