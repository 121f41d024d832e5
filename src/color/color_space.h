#pragma once

// Colour spaces: what R, G and B of a picture mean, to and from linear Rec.709.
//
// Known by name without any file: sRGB, Linear Rec.709, ACEScg, ACES2065-1, Linear Rec.2020, Linear
// P3-D65, Display P3, Adobe RGB (1998), Gamma 2.2 Rec.709, Rec.2100 PQ, Rec.2100 HLG and Raw
// (numbers taken as they are). Case, blanks and separators do not matter, and the names other
// programs give them are understood (lin_rec709, lin_srgb, linear, lin_ap1, …). If $OCIO names an
// OpenColorIO configuration, its colour spaces, aliases and roles are found too, and before the
// ones above: a space of the configuration that means something else than ours of the same name is
// called "sRGB ($OCIO)".
//
// White stays white: spaces with another white point are adapted (Bradford). Values below 0 and
// above 1 are carried through; transfer curves continue oddly below 0. NaN in a channel gives NaN
// in that pixel. Matrices and curves are those of the standards to within float rounding.

#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "core/base/result.h"
#include "src/color/transfer_curve.h"

namespace cutis {

// Converts interleaved R, G, B in place; the size is a multiple of 3. Any number of threads may
// call one converter at once. Fails only if a configuration's own transform does.
using ColorConverter = std::function<Status(std::span<float> rgb)>;

// Curves and a matrix, which is what most spaces are.
struct ColorMatrix {
  std::array<TransferCurve, 3> curves;
  // Linear R, G, B to linear Rec.709, white onto white.
  Eigen::Matrix3d toRec709 = Eigen::Matrix3d::Identity();
  // x, y of red, green, blue and white where a file can state them; nothing if only the matrix is
  // known.
  std::optional<std::array<double, 8>> chromaticities;

  bool isLinear() const;
};

// A value; copies share. Spaces of one name are one space.
struct ColorSpace {
  // Shown to people: "sRGB", "the ICC profile 'studio'", "Gamma 1.8, primaries 0.64 …".
  std::string name;
  // Both there unless the name is empty.
  ColorConverter toLinearRec709;
  ColorConverter fromLinearRec709;
  // Nothing for tables and for what a configuration defines.
  std::shared_ptr<const ColorMatrix> matrix;
  // The bytes of the ICC profile that the space was read from; may be null.
  std::shared_ptr<const std::string> profile;
  // A name that stands for the space in files: namedColorSpace() finds it again.
  bool isNamed = false;

  bool empty() const { return name.empty(); }
  // Whether numbers are proportional to light; false where it is not known.
  bool isLinear() const { return matrix && matrix->isLinear(); }
};

// `place` stands in front of an error about the name: "colour space", "face.exr".
Result<ColorSpace> namedColorSpace(const std::string& name, const std::string& place);

// One of the spaces that need no file, whatever $OCIO says. Precondition: its canonical name.
const ColorSpace& builtInColorSpace(const std::string& name);

// x, y of red, green, blue and white. Gets the name of a built-in space where it is one. Fails with
// a sentence if the primaries span no space.
Result<ColorSpace> spaceOfPrimaries(const std::array<double, 8>& chromaticities,
                                    const std::array<TransferCurve, 3>& curves,
                                    const std::string& place);
Result<ColorSpace> spaceOfPrimaries(const std::array<double, 8>& chromaticities,
                                    const TransferCurve& curve, const std::string& place);

// The space in numbers of which these mean black and white, as video counts. Precondition: it has a
// matrix.
ColorSpace inNarrowRange(const ColorSpace& space, double black, double white);

// The largest difference in linear light between what two spaces make of the same numbers from 0 to
// 1; white is 1.
double differenceOf(const ColorSpace& a, const ColorSpace& b);

Result<ColorConverter> toLinearRec709(const std::string& name, const std::string& place);
Result<ColorConverter> fromLinearRec709(const std::string& name, const std::string& place);

// The one spelling of a name that is shown to people and written to files.
Result<std::string> canonicalColorSpace(const std::string& name, const std::string& place);

// What may be offered for choice: the spaces above, then those of $OCIO if it can be read.
std::vector<std::string> colorSpaceNames();

}  // namespace cutis
