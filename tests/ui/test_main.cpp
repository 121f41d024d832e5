#include <QApplication>
#include <QTemporaryDir>

#include "tests/support/test_registry.h"
#include "ui/theme/theme.h"

int main(int argc, char** argv) {
  // Pixels are looked up in pictures of the widgets.
  qputenv("QT_SCALE_FACTOR", "1");
  // What windows keep between sessions is not the user's.
  const QTemporaryDir kept;
  for (const char* folder : {"XDG_CACHE_HOME", "XDG_STATE_HOME"})
    qputenv(folder, kept.filePath(folder).toUtf8());
  QApplication application(argc, argv);
  cutis::theme::apply(application);
  return cutis::test::runAll(argc, argv);
}
