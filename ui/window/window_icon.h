#pragma once

// The icon of the program, as it travels inside it. Interface thread only.

#include <QIcon>

namespace cutis {

QIcon windowIcon();

}  // namespace cutis
