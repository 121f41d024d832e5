#include <QCoreApplication>

#include "tests/support/test_registry.h"

int main(int argc, char** argv) {
  const QCoreApplication application(argc, argv);
  return cutis::test::runAll(argc, argv);
}
