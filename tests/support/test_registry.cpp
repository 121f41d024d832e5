#include "tests/support/test_registry.h"

#include <utility>
#include <vector>

#include <QtTest>

namespace cutis::test {
namespace {

std::vector<std::function<std::unique_ptr<QObject>()>>& registered() {
  static std::vector<std::function<std::unique_ptr<QObject>()>> makers;
  return makers;
}

}  // namespace

Registration::Registration(std::function<std::unique_ptr<QObject>()> make) {
  registered().push_back(std::move(make));
}

int runAll(int argc, char** argv) {
  int failures = 0;
  for (const auto& make : registered())
    failures += QTest::qExec(make().get(), argc, argv);
  return failures == 0 ? 0 : 1;
}

}  // namespace cutis::test
