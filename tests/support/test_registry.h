#pragma once

// Test classes of one program. CUTIS_TEST(Class) at the end of a file adds a QObject whose private
// slots are the tests; the program runs all of them.

#include <functional>
#include <memory>

#include <QObject>

namespace cutis::test {

struct Registration {
  explicit Registration(std::function<std::unique_ptr<QObject>()> make);
};

int runAll(int argc, char** argv);

}  // namespace cutis::test

#define CUTIS_TEST(Class)                                         \
  static const cutis::test::Registration registration_of_##Class( \
      [] { return std::unique_ptr<QObject>(std::make_unique<Class>()); });
