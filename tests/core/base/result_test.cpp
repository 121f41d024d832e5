#include "core/base/result.h"

#include <memory>
#include <string>
#include <vector>

#include <QtTest>

#include "core/base/progress.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

Result<int> number() {
  return 42;
}
Result<int> broken() {
  return inputError("face.exr", "it is torn; use another");
}
Result<int> stopped() {
  return Cancelled{};
}

// Counts how far a chain of steps got.
Result<std::string> chain(Result<int> first, int& reached) {
  reached = 0;
  CUTIS_TRY(value, std::move(first));
  reached = 1;
  value += 1;
  CUTIS_TRY(other, number());
  reached = 2;
  return std::to_string(value + other);
}

Status checked(Status first, int& reached) {
  reached = 0;
  CUTIS_CHECK(std::move(first));
  reached = 1;
  return {};
}

class ResultTest : public QObject {
  Q_OBJECT

 private slots:
  void isOneOfThree() {
    QVERIFY(number() && !number().failed() && !number().cancelled());
    QVERIFY(!broken() && broken().failed() && !broken().cancelled());
    QVERIFY(!stopped() && !stopped().failed() && stopped().cancelled());
    QCOMPARE(number().value(), 42);
    QCOMPARE(broken().error().text(), std::string("face.exr: it is torn; use another"));
  }

  void statusIsOneOfThree() {
    const Status done = {};
    const Status failed = usageError("--noise", "two numbers are needed");
    const Status cancelled = Cancelled{};
    QVERIFY(done && !done.failed() && !done.cancelled());
    QVERIFY(!failed && failed.failed() && !failed.cancelled());
    QVERIFY(!cancelled && !cancelled.failed() && cancelled.cancelled());
    QVERIFY(failed.error().kind == ErrorKind::usage);
  }

  void textLeavesOutAnEmptyPlace() {
    QCOMPARE(resourceError("", "the disk is full").text(), std::string("the disk is full"));
    QCOMPARE(inputError("a.json:3:7", "wrong").text(), std::string("a.json:3:7: wrong"));
  }

  void kindsAreKept() {
    QVERIFY(usageError("", "").kind == ErrorKind::usage);
    QVERIFY(inputError("", "").kind == ErrorKind::input);
    QVERIFY(resourceError("", "").kind == ErrorKind::resource);
  }

  void tryGoesOnWithAValue() {
    int reached = 0;
    const auto result = chain(number(), reached);
    EXPECT_OK(result);
    QCOMPARE(result.value(), std::string("85"));
    QCOMPARE(reached, 2);
  }

  void tryReturnsAnErrorAsItIs() {
    int reached = -1;
    const auto result = chain(broken(), reached);
    QCOMPARE(reached, 0);
    QVERIFY(result.failed());
    QCOMPARE(result.error().place, std::string("face.exr"));
    QVERIFY(result.error().kind == ErrorKind::input);
  }

  // Being cancelled is not an error and must not become one on the way up.
  void tryReturnsCancelledAsCancelled() {
    int reached = -1;
    QVERIFY(chain(stopped(), reached).cancelled());
    QCOMPARE(reached, 0);
  }

  void checkDoesTheSameForAStatus() {
    int reached = -1;
    QVERIFY(bool(checked({}, reached)));
    QCOMPARE(reached, 1);
    QVERIFY(checked(Cancelled{}, reached).cancelled());
    QCOMPARE(reached, 0);
    EXPECT_ERROR(checked(resourceError("disk", "full"), reached), "disk: full");
    QCOMPARE(reached, 0);
  }

  void aFailureFitsAnyResult() {
    const Result<std::vector<int>> fromError = broken().failure();
    QVERIFY(fromError.failed());
    QCOMPARE(fromError.error().place, std::string("face.exr"));
    const Result<std::vector<int>> fromCancelled = stopped().failure();
    QVERIFY(fromCancelled.cancelled());
    const Status status = broken().failure();
    QVERIFY(status.failed());
    const Status cancelled = stopped().failure();
    QVERIFY(cancelled.cancelled());
  }

  void movesWhatCannotBeCopied() {
    Result<std::unique_ptr<int>> result = std::make_unique<int>(7);
    const std::unique_ptr<int> taken = std::move(result).value();
    QCOMPARE(*taken, 7);
  }
};

struct Report {
  double fraction;
  std::string stage;
};

class ProgressTest : public QObject {
  Q_OBJECT

 private slots:
  void composesByFractions() {
    std::vector<Report> reports;
    const Progress whole([&](double f, const std::string& s) { reports.push_back({f, s}); }, "job");
    const Progress part = whole.child(0.2, 0.9, "melanin");
    const Progress inner = part.child(0.5, 1.0);
    whole.report(0.1);
    part.report(0.0);
    part.report(1.0);
    inner.report(0.0);
    inner.report(0.5);
    inner.report(1.0);
    const std::vector<double> expected = {0.1, 0.2, 0.9, 0.55, 0.725, 0.9};
    QCOMPARE(reports.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      EXPECT_NEAR(reports[i].fraction, expected[i], 1e-15);
      QCOMPARE(reports[i].stage, std::string(i == 0 ? "job" : "melanin"));
    }
  }

  // Chained parts that cover [0, 1] cover it without gaps, however deep.
  void depthLosesNothing() {
    double last = -1.0;
    Progress progress([&](double f, const std::string&) { last = f; });
    for (int depth = 0; depth < 20; ++depth)
      progress = progress.child(0.0, 1.0, "deeper");
    progress.report(0.0);
    EXPECT_NEAR(last, 0.0, 0.0);
    progress.report(1.0);
    EXPECT_NEAR(last, 1.0, 0.0);
  }

  void reportsToNobody() { Progress().child(0.1, 0.2, "x").report(0.5); }
};

CUTIS_TEST(ResultTest)
CUTIS_TEST(ProgressTest)

}  // namespace
}  // namespace cutis

#include "result_test.moc"
