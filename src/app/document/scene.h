#pragma once

// Everything that pictures of a document are made of, at one moment.

#include <memory>

#include "core/render/edited_skin.h"
#include "core/render/skin_spectra.h"
#include "src/app/document/fit_evidence.h"
#include "src/app/open/source.h"

namespace cutis {

// Cheap to copy; any thread may read it.
struct Scene : EditedSkin {
  std::shared_ptr<const Source> source;  // null if maps were opened by themselves
  // For the constants that the maps bring along; null where they bring none.
  std::shared_ptr<const SkinSpectra> spectra;
  // Of the fit that the maps are of; null where there was none, or its photographs are not at hand.
  std::shared_ptr<FitEvidence> evidence;
};

}  // namespace cutis
