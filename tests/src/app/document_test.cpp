// Document and view server together, on the embedded sample.

#include "src/app/document/document.h"

#include <cstdint>
#include <fstream>
#include <optional>

#include <QSignalSpy>
#include <QtTest>

#include "src/app/views/view_server.h"
#include "tests/support/expect.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr int kPatienceMs = 120000;

Command scaleMelanin(double factor, bool moving = false) {
  return {"melanin", "melanin",
          [factor](DocumentState& state) {
            if (state.edits.empty()) state.edits.emplace_back();
            state.edits.front().parameters[kMelanin].scale = factor;
          },
          moving};
}

// Nothing where there is no such counter.
std::optional<std::int64_t> bytesReadByThisThread() {
  std::ifstream counters("/proc/thread-self/io");
  std::string name;
  std::int64_t bytes = 0;
  if (counters >> name >> bytes && name == "rchar:") return bytes;
  return std::nullopt;
}

class DocumentTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    QSignalSpy opened(&document_, &Document::opened), maps(&document_, &Document::mapsChanged);
    document_.openSample();
    QVERIFY(!document_.isOpen());
    QTRY_COMPARE_WITH_TIMEOUT(opened.count(), 1, kPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(document_.isFitted(), kPatienceMs);
    QVERIFY(maps.count() >= 1);
    QTRY_VERIFY(jobs_.isIdle());
  }
  void cleanupTestCase() { jobs_.stopAll(); }
  void init() {
    while (document_.history().canUndo())
      document_.undo();
    QTRY_VERIFY_WITH_TIMEOUT(jobs_.isIdle(), kPatienceMs);
  }

  void nobodyWatchesNothingIsComputed() {
    QSignalSpy idle(&jobs_, &JobRunner::idle);
    document_.apply(scaleMelanin(1.5));
    QTest::qWait(30);
    QCOMPARE(idle.count(), 0);
    QVERIFY(jobs_.isIdle());
  }

  // And once, whatever changed meanwhile, when it is seen again.
  void whatNobodySeesIsNotComputed() {
    int served = 0;
    const auto watch = server_.watch(ViewPriority::thumbnail, [&](const auto&) { ++served; });
    watch->setSeen(false);
    QSignalSpy idle(&jobs_, &JobRunner::idle);
    watch->want({ViewKind::skin, {300, 300, 400, 380}, 2});
    document_.apply(scaleMelanin(1.4));
    document_.apply(scaleMelanin(1.6));
    QTest::qWait(30);
    QCOMPARE(idle.count(), 0);
    QVERIFY(server_.isIdle());
    watch->setSeen(true);
    QTRY_COMPARE(served, 1);
    watch->setSeen(false);
    watch->setSeen(true);  // nothing new
    QTest::qWait(30);
    QCOMPARE(served, 1);
  }

  void aWatchIsServedWheneverItsPartChanges() {
    QVector<ViewRequest> served;
    const auto watch =
        server_.watch(ViewPriority::detail, [&](const auto& part) { served << part->request; });
    const ViewRequest request = {ViewKind::skin, {300, 300, 400, 380}, 1};
    watch->want(request);
    QTRY_COMPARE(served.size(), 1);
    QVERIFY(served[0] == request);
    watch->want(request);  // nothing new
    document_.apply(scaleMelanin(1.3));
    QTRY_COMPARE(served.size(), 2);
    server_.setPicture({"A", "cie1931", ChromaticAdaptation::none, std::nullopt});
    QTRY_COMPARE_WITH_TIMEOUT(served.size(), 3, kPatienceMs);
    QTest::qWait(20);
    QCOMPARE(served.size(), 3);
  }

  void whileAControlMovesPartsAreCoarseAndThenFine() {
    QVector<int> steps;
    const auto watch =
        server_.watch(ViewPriority::detail, [&](const auto& part) { steps << part->request.step; });
    watch->want({ViewKind::melanin, {0, 0, 512, 512}, 1});
    QTRY_COMPARE(steps.size(), 1);
    document_.apply(scaleMelanin(1.1, true));
    QTRY_VERIFY(steps.size() >= 2);
    QCOMPARE(steps[1], 2);
    steps.clear();
    document_.apply(scaleMelanin(1.2));
    QTRY_VERIFY(server_.isIdle());
    QCOMPARE(steps.last(), 1);
  }

  void aWatchThatIsGoneIsNotServed() {
    int served = 0;
    auto watch = server_.watch(ViewPriority::detail, [&](const auto&) { ++served; });
    watch->want({ViewKind::skin, {0, 0, 1024, 1024}, 1});
    watch.reset();
    QTRY_VERIFY_WITH_TIMEOUT(jobs_.isIdle(), kPatienceMs);
    QCOMPARE(served, 0);
  }

  // What was computed for a watch that is gone is not for the next one, which may well lie at the
  // same address.
  void aWatchInThePlaceOfAnotherIsServedItsOwnPart() {
    const ViewRequest old = {ViewKind::melanin, {0, 0, 1024, 1024}, 1};
    const ViewRequest own = {ViewKind::melanin, {300, 300, 400, 380}, 2};
    QVector<ViewRequest> served;
    auto watch = server_.watch(ViewPriority::detail, [](const auto&) {});
    watch->want(old);
    watch.reset();
    watch = server_.watch(ViewPriority::detail, [&](const auto& part) { served << part->request; });
    watch->want(own);
    QTRY_VERIFY(server_.isIdle());
    QCOMPARE(served.size(), 1);
    QVERIFY(served[0] == own);
  }

  void detailComesBeforeOverviewAndThumbnail() {
    QVector<ViewPriority> order;
    std::vector<std::unique_ptr<ViewWatch>> watches;
    for (const auto priority :
         {ViewPriority::thumbnail, ViewPriority::overview, ViewPriority::detail}) {
      watches.push_back(
          server_.watch(priority, [&order, priority](const auto&) { order << priority; }));
      watches.back()->want({ViewKind::melanin, {0, 0, 64, 64}, 1});
    }
    QTRY_COMPARE(order.size(), 3);
    order.clear();
    document_.apply(scaleMelanin(1.4));
    QTRY_COMPARE(order.size(), 3);
    QCOMPARE(order, (QVector<ViewPriority>{ViewPriority::detail, ViewPriority::overview,
                                           ViewPriority::thumbnail}));
  }

  // A part is what the whole picture has there, whatever its step and bands.
  void partsAgreeWithTheMaps() {
    std::shared_ptr<const ViewPart> part;
    const auto watch =
        server_.watch(ViewPriority::detail, [&](const auto& served) { part = served; });
    const ViewRequest request = {ViewKind::melanin, {255, 250, 600, 421}, 3};
    watch->want(request);
    QTRY_VERIFY(part != nullptr);
    const Plane& plane = document_.scene().maps.values[kMelanin];
    QCOMPARE(part->pixels.width, 115);
    QCOMPARE(part->pixels.height, 57);
    for (int y = 0; y < part->pixels.height; ++y) {
      for (int x = 0; x < part->pixels.width; ++x) {
        const int px = request.rect.x0 + 3 * x, py = request.rect.y0 + 3 * y;
        float expected = 0.0f;
        QVERIFY(plane.load({px, py, px + 1, py + 1}, {&expected, 1}));
        const auto i = static_cast<std::size_t>(y * part->pixels.width + x);
        if (part->pixels.present[i]) QCOMPARE(part->pixels.channels[0][i], expected);
      }
    }
  }

  void undoBringsTheEditsBack() {
    QSignalSpy changed(&document_, &Document::editsChanged);
    document_.apply(scaleMelanin(2.0));
    document_.endGroup();
    document_.apply(scaleMelanin(3.0));
    document_.undo();
    QCOMPARE(document_.scene().edits.front().parameters[kMelanin].scale, 2.0);
    document_.undo();
    QVERIFY(document_.scene().edits.empty());
    document_.undo();  // nothing left
    QCOMPARE(changed.count(), 4);
  }

  // And what comes after it is a step of its own, in place of what was undone.
  void aStepOfTheHistoryIsReachedAtOnce() {
    for (const double factor : {1.2, 1.4, 1.6}) {
      document_.apply(scaleMelanin(factor));
      document_.endGroup();
    }
    const UndoHistory& history = document_.history();
    const std::size_t newest = history.position();
    QCOMPARE(history.stepCount(), newest + 1);
    document_.goToStep(newest - 2);
    QCOMPARE(document_.scene().edits.front().parameters[kMelanin].scale, 1.2);
    document_.goToStep(newest);
    QCOMPARE(document_.scene().edits.front().parameters[kMelanin].scale, 1.6);
    QSignalSpy changed(&document_, &Document::editsChanged);
    document_.goToStep(newest);
    document_.goToStep(newest + 5);
    QCOMPARE(changed.count(), 0);
    document_.goToStep(newest - 1);
    document_.apply(scaleMelanin(3.0));
    QCOMPARE(history.stepCount(), newest + 1);
    QVERIFY(!history.canRedo());
  }

  // Whether a file is maps is found out in the background, as the rest of it is read.
  void openingReadsNothingOnTheInterfaceThread() {
    const test::ScratchFolder folder;
    const std::string file = folder.write("large.exr", std::string(1 << 20, '\x76')).string();
    const auto before = bytesReadByThisThread();
    if (!before) QSKIP("the system does not count what a thread reads");
    const auto again = bytesReadByThisThread();
    QSignalSpy failed(&document_, &Document::failed);
    document_.open(file);
    const auto after = bytesReadByThisThread();
    QTRY_COMPARE(failed.count(), 1);
    // What the counter itself is read with, whose length may grow by some digits.
    EXPECT_AT_MOST(*after - *again, *again - *before + 8);
  }

  void aFailureLeavesWhatIsOpen() {
    QSignalSpy failed(&document_, &Document::failed), opened(&document_, &Document::opened);
    document_.open("no such file.exr");
    QTRY_COMPARE(failed.count(), 1);
    QVERIFY(failed[0][0].toString().contains("no such file.exr"));
    QCOMPARE(opened.count(), 0);
    QVERIFY(document_.isFitted());
  }

 private:
  Engine engine_{std::filesystem::path()};
  JobRunner jobs_;
  Document document_{engine_, jobs_};
  ViewServer server_{document_, engine_, jobs_};
};

CUTIS_TEST(DocumentTest)

}  // namespace
}  // namespace cutis

#include "document_test.moc"
