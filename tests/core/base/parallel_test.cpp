#include "core/base/parallel.h"

#include <atomic>
#include <chrono>
#include <new>
#include <thread>
#include <vector>

#include <QtTest>
#include <tbb/global_control.h>

#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

class ParallelTest : public QObject {
  Q_OBJECT

 private slots:
  void everyPieceOnce() {
    for (const std::size_t count : {0, 1, 2, 7, 1000}) {
      std::vector<std::atomic<int>> calls(count);
      EXPECT_OK(parallelFor(count, {}, [&](std::size_t i) -> Status {
        ++calls[i];
        return {};
      }));
      for (const auto& called : calls)
        QCOMPARE(called.load(), 1);
    }
  }

  // Whatever the timing: later pieces that fail first must not hide an earlier one.
  void theLowestFailureIsReported() {
    for (int repetition = 0; repetition < 50; ++repetition) {
      const Status status = parallelFor(200, {}, [&](std::size_t i) -> Status {
        if (i < 20) return {};
        if (i < 30) std::this_thread::sleep_for(std::chrono::microseconds(200));
        return inputError("piece " + std::to_string(i), "failed");
      });
      EXPECT_ERROR(status, "piece 20: failed");
    }
  }

  void aFailureStopsWhatComesLater() {
    std::atomic<int> calls = 0;
    const Status status = parallelFor(100000, {}, [&](std::size_t) -> Status {
      ++calls;
      return inputError("", "failed");
    });
    QVERIFY(status.failed());
    QVERIFY2(calls < 50000, qPrintable(QString::number(calls.load())));
  }

  void stopsWhenAskedTo() {
    std::stop_source source;
    JobContext context;
    context.stop = source.get_token();
    std::atomic<int> calls = 0;
    const Status status = parallelFor(100000, context, [&](std::size_t) -> Status {
      if (++calls == 10) source.request_stop();
      return {};
    });
    QVERIFY(status.cancelled());
    QVERIFY2(calls < 10000, qPrintable(QString::number(calls.load())));
  }

  void stoppedBeforehandDoesNothing() {
    std::stop_source source;
    source.request_stop();
    JobContext context;
    context.stop = source.get_token();
    bool called = false;
    QVERIFY(parallelFor(10, context, [&](std::size_t) -> Status {
              called = true;
              return {};
            }).cancelled());
    QVERIFY(!called);
  }

  // A failure is more than a cancellation: the user must hear of it.
  void aFailureBeforeTheStopIsReported() {
    std::stop_source source;
    JobContext context;
    context.stop = source.get_token();
    const Status status = parallelFor(100, context, [&](std::size_t i) -> Status {
      if (i != 0) return {};
      source.request_stop();
      return resourceError("disk", "full");
    });
    EXPECT_ERROR(status, "disk: full");
  }

  void cancelledPiecesCancelTheLoop() {
    QVERIFY(parallelFor(10, {}, [](std::size_t) -> Status { return Cancelled{}; }).cancelled());
  }

  void memoryThatRunsOutIsAResourceError() {
    const Status status = parallelFor(10, {}, [](std::size_t i) -> Status {
      if (i == 3) throw std::bad_alloc();
      return {};
    });
    EXPECT_ERROR(status, "memory");
    QVERIFY(status.error().kind == ErrorKind::resource);
  }

  void progressCountsEveryPieceAndReachesOne() {
    constexpr std::size_t count = 500;
    std::vector<double> reports;  // parallelFor reports one at a time
    JobContext context;
    context.progress =
        Progress([&](double fraction, const std::string&) { reports.push_back(fraction); });
    EXPECT_OK(parallelFor(count, context, [](std::size_t) -> Status { return {}; }));
    QCOMPARE(reports.size(), count);
    for (std::size_t i = 0; i < count; ++i) {
      EXPECT_NEAR(reports[i], static_cast<double>(i + 1) / static_cast<double>(count), 0.0);
    }
  }

  void theSameOutcomeForAnyThreadCount() {
    std::vector<double> first;
    for (const std::size_t threads : {1, 2, 7}) {
      const tbb::global_control limit(tbb::global_control::max_allowed_parallelism, threads);
      std::vector<double> out(333);
      EXPECT_OK(parallelFor(out.size(), {}, [&](std::size_t i) -> Status {
        out[i] = 1.0 / (1.0 + static_cast<double>(i));
        return {};
      }));
      if (first.empty()) first = out;
      QVERIFY(out == first);
    }
  }

  void loopsNest() {
    std::atomic<int> calls = 0;
    EXPECT_OK(parallelFor(20, {}, [&](std::size_t) -> Status {
      return parallelFor(20, {}, [&](std::size_t) -> Status {
        ++calls;
        return {};
      });
    }));
    QCOMPARE(calls.load(), 400);
  }

  void thereIsAtLeastOneThread() {
    QVERIFY(parallelThreadCount() >= 1);
    const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
    QCOMPARE(parallelThreadCount(), 1);
  }
};

CUTIS_TEST(ParallelTest)

}  // namespace
}  // namespace cutis

#include "parallel_test.moc"
