#pragma once  // internal to src/color

// Colour spaces that are defined by themselves. OpenColorIO follows such a definition until the
// stack ends, so it must be asked for before a conversion is built.

#include <string>

#include <OpenColorIO/OpenColorIO.h>

namespace cutis {

// Whether the definition of this space, through other spaces, looks, views and named transforms,
// comes back to something it is made of.
bool refersToItself(const OCIO_NAMESPACE::Config& config, const std::string& name);

}  // namespace cutis
