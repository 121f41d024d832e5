#include <QApplication>

#include "tests/support/test_registry.h"
#include "ui/theme/theme.h"

int main(int argc, char** argv) {
  // Pixels are looked up in pictures of the widgets.
  qputenv("QT_SCALE_FACTOR", "1");
  QApplication application(argc, argv);
  cutis::theme::apply(application);
  return cutis::test::runAll(argc, argv);
}
