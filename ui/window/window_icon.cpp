#include "ui/window/window_icon.h"

#include <string>

#include <QPixmap>

#include "src/files/resources.h"

namespace cutis {

QIcon windowIcon() {
  QIcon icon;
  for (const int size : {16, 32, 64, 256}) {
    const auto bytes = resource("icons/cutis-" + std::to_string(size) + ".png");
    QPixmap pixmap;
    if (bytes && pixmap.loadFromData(reinterpret_cast<const uchar*>(bytes->data()),
                                     static_cast<uint>(bytes->size()), "PNG")) {
      icon.addPixmap(pixmap);
    }
  }
  return icon;
}

}  // namespace cutis
