#include <QGuiApplication>

#include "tests/support/test_registry.h"

// Fonts, which PNG needs, need an application.
int main(int argc, char** argv) {
  QGuiApplication application(argc, argv);
  return cutis::test::runAll(argc, argv);
}
