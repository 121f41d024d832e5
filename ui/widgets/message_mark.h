#pragma once

// The mark before a message: a triangle for errors, a disc for notices; never colour alone.
// Interface thread only.

#include <QPixmap>

namespace cutis {

QPixmap messageMark(bool isError);

}  // namespace cutis
