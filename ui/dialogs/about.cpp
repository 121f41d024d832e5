#include "ui/dialogs/about.h"

#include <QCoreApplication>
#include <QMessageBox>

namespace cutis {
namespace {

QString tr(const char* text) {
  return QCoreApplication::translate("About", text);
}

}  // namespace

void showAbout(QWidget& window) {
  QMessageBox::about(
      &window, tr("About Cutis"),
      tr("<b>Cutis %1</b><p>An editor for human skin. It implements and extends the model of "
         "Li, Guarnera, Lin, Ghosh 2024, <i>Practical Measurement and Neural Encoding of "
         "Hyperspectral Skin Reflectance</i>.</p><p>Licence: Apache-2.0. Nothing you open leaves "
         "this machine.</p>")
          .arg(QCoreApplication::applicationVersion()));
}

}  // namespace cutis
