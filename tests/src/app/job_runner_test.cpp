#include "src/app/job_runner.h"

#include <atomic>
#include <chrono>
#include <new>
#include <stdexcept>

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

  // Without this the program would end, and all that is open in it.
  void whatAJobThrowsIsOneSentence_data() {
    QTest::addColumn<int>("thrown");
    QTest::addColumn<QString>("words");
    QTest::newRow("an error") << 0 << "the disk is made of cheese";
    QTest::newRow("no memory") << 1 << "not enough memory";
    QTest::newRow("anything") << 2 << "Internal error";
  }
  void whatAJobThrowsIsOneSentence() {
    QFETCH(int, thrown);
    QFETCH(QString, words);
    JobRunner jobs;
    QSignalSpy failed(&jobs, &JobRunner::failed), finished(&jobs, &JobRunner::finished);
    const JobId id = jobs.start("work", [thrown](const JobRunner::Handle&) {
      if (thrown == 0) throw std::runtime_error("the disk is\nmade of cheese");
      if (thrown == 1) throw std::bad_alloc();
      throw 7;
    });
    QTRY_COMPARE(finished.count(), 1);
    QCOMPARE(failed.count(), 1);
    QCOMPARE(failed[0][0].value<JobId>(), id);
    const QString sentence = failed[0][1].toString();
    QVERIFY2(sentence.contains(words) && !sentence.contains('\n'), qPrintable(sentence));
    QVERIFY(jobs.isIdle());
  }

  void aQuietJobThatThrowsIsToldToo() {
    JobRunner jobs;
    QSignalSpy failed(&jobs, &JobRunner::failed);
    jobs.startQuiet([](const JobRunner::Handle&) { throw std::bad_alloc(); });
    QTRY_COMPARE(failed.count(), 1);
  }

  void whatACancelledJobThrowsIsNobodysBusiness() {
    JobRunner jobs;
    QSignalSpy failed(&jobs, &JobRunner::failed);
    const JobId id = jobs.start("work", [](const JobRunner::Handle& job) {
      workUntilStopped(job);
      throw std::bad_alloc();
    });
    jobs.cancel(id);
    QTest::qWait(50);
    QCOMPARE(failed.count(), 0);
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
