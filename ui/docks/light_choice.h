#pragma once  // internal to ui/docks

// Under which light, and by whose eyes, the skin is shown.

#include <QMetaType>
#include <QString>
#include <QStringList>

#include "core/spectra/colorimetry.h"

namespace cutis {

struct LightChoice {
  enum class Kind {
    colour,        // a light and an observer
    ultraviolet,   // mean reflectance 300–400 nm, grey
    nearInfrared,  // mean reflectance 700–1000 nm, grey
  };

  // Kept while a band is shown, so that the way back leads to the same light.
  QString light;
  QString observer;
  Kind kind = Kind::colour;
  // How white under the light becomes white under daylight; of observers alone.
  ChromaticAdaptation adaptation = ChromaticAdaptation::none;

  bool operator==(const LightChoice&) const = default;
};

struct LightGroup {
  QString title;  // "Daylight"
  QStringList names;
};

}  // namespace cutis

Q_DECLARE_METATYPE(cutis::LightChoice)
