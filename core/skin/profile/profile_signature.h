#pragma once

// Who a profile is, with patience for rounding; fingerprint() of core/skin/profile/profile.h has
// none.

#include "core/skin/profile/profile.h"
#include "core/spectra/signature.h"

namespace cutis {

// The signature of everything that changes a reflectance or a table: profiles whose constants and
// spectra are the same up to rounding are alike(). The prior, the name and the description are not
// part of it. Thread-safe.
Signature signatureOf(const Profile& profile);

}  // namespace cutis
