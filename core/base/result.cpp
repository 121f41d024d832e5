#include "core/base/result.h"

#include "core/base/echoed_text.h"

namespace cutis {

std::string Error::text() const {
  return place.empty() ? message : shortenedPlace(place) + ": " + message;
}

}  // namespace cutis
