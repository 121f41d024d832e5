#pragma once

// Memory that was freed goes back to the system only when somebody says so.

namespace cutis {

// Gives back what is free. Takes a tenth of a second for some gigabytes. Thread-safe; does nothing
// where the system cannot.
void giveFreeMemoryBack();

}  // namespace cutis
