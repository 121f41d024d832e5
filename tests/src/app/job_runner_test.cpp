#include "src/app/job_runner.h"

#include <atomic>
#include <chrono>

#include <QSignalSpy>
#include <QtTest>

#include "tests/support/test_registry.h"

namespace cutis {
namespace {

void workUntilStopped(const JobRunner::Handle& job) {
  while (!job.context.stopRequested())
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
}

class JobRunnerTest : public QObject {
  Q_OBJECT

 private slots:
  void resultsArriveOnTheInterfaceThread() {
    JobRunner jobs;
    QThread* thread = nullptr;
    jobs.start("work", [&](const JobRunner::Handle& job) {
      job.post([&] { thread = QThread::currentThread(); });
    });
    QTRY_VERIFY(jobs.isIdle());
    QCOMPARE(thread, QThread::currentThread());
  }

  void finishedAndIdleAreTold() {
    JobRunner jobs;
    QSignalSpy started(&jobs, &JobRunner::started), finished(&jobs, &JobRunner::finished),
        idle(&jobs, &JobRunner::idle);
    const JobId id = jobs.start("work", [](const JobRunner::Handle&) {});
    QVERIFY(jobs.isRunning(id));
    QTRY_COMPARE(idle.count(), 1);
    QCOMPARE(started.count(), 1);
    QCOMPARE(finished.count(), 1);
    QVERIFY(!jobs.isRunning(id));
  }

  // What was on its way when the job was cancelled does not arrive.
  void nothingArrivesAfterCancelling() {
    JobRunner jobs;
    std::atomic<bool> posted = false;
    bool arrived = false;
    const JobId id = jobs.start("work", [&](const JobRunner::Handle& job) {
      job.post([&] { arrived = true; });
      posted = true;
      workUntilStopped(job);
    });
    while (!posted)
      std::this_thread::yield();
    jobs.cancel(id);
    QVERIFY(jobs.isIdle());
    QTest::qWait(50);
    QVERIFY(!arrived);
  }

  void cancellingReturnsAtOnceAndTwiceIsOnce() {
    JobRunner jobs;
    QSignalSpy finished(&jobs, &JobRunner::finished);
    std::atomic<bool> mayEnd = false;
    const JobId id = jobs.start("deaf", [&](const JobRunner::Handle&) {
      while (!mayEnd)
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    });
    jobs.cancel(id);
    jobs.cancel(id);
    jobs.cancel(12345);
    QCOMPARE(finished.count(), 1);
    mayEnd = true;
  }

  void quietJobsAreNotShown() {
    JobRunner jobs;
    QSignalSpy started(&jobs, &JobRunner::started), finished(&jobs, &JobRunner::finished);
    jobs.startQuiet([](const JobRunner::Handle&) {});
    QVERIFY(!jobs.isBusy());
    QTRY_VERIFY(jobs.isIdle());
    QCOMPARE(started.count() + finished.count(), 0);
  }

  void progressIsToldWithStageAndTime() {
    JobRunner jobs;
    QSignalSpy progressed(&jobs, &JobRunner::progressed);
    const JobId id = jobs.start("work", [](const JobRunner::Handle& job) {
      job.context.child(0.0, 1.0, "melanin").progress.report(0.5);
      workUntilStopped(job);
    });
    QTRY_COMPARE(progressed.count(), 1);
    QCOMPARE(progressed[0][1].toString(), QString("melanin"));
    QCOMPARE(progressed[0][2].toDouble(), 0.5);
    QVERIFY(progressed[0][3].toDouble() >= 0.0);
    jobs.cancel(id);
  }

  void destructionStopsEverything() {
    std::atomic<int> ended = 0;
    {
      JobRunner jobs;
      for (int i = 0; i < 4; ++i) {
        jobs.start("work", [&](const JobRunner::Handle& job) {
          workUntilStopped(job);
          ++ended;
        });
      }
    }
    QCOMPARE(ended.load(), 4);
  }
};

CUTIS_TEST(JobRunnerTest)

}  // namespace
}  // namespace cutis

#include "job_runner_test.moc"
