#include "src/app/document/undo_history.h"

#include <QtTest>

#include "tests/support/test_registry.h"

namespace cutis {
namespace {

DocumentState withMelanin(double factor) {
  DocumentState state;
  state.edits.emplace_back();
  state.edits.front().parameters[kMelanin].scale = factor;
  return state;
}

double melanin(const UndoHistory& history) {
  const EditStack& edits = history.current().edits;
  return edits.empty() ? 1.0 : edits.front().parameters[kMelanin].scale;
}

class UndoHistoryTest : public QObject {
  Q_OBJECT

 private slots:
  void beginsWithNothingToUndo() {
    const UndoHistory history;
    QVERIFY(!history.canUndo());
    QVERIFY(!history.canRedo());
    QCOMPARE(history.undoName(), QString());
  }

  void stepsGoBackAndForth() {
    UndoHistory history;
    history.push("one", {}, withMelanin(2.0));
    history.push("two", {}, withMelanin(3.0));
    QCOMPARE(history.undoName(), QString("two"));
    history.undo();
    QCOMPARE(melanin(history), 2.0);
    QCOMPARE(history.redoName(), QString("two"));
    history.undo();
    QCOMPARE(melanin(history), 1.0);
    history.redo();
    history.redo();
    QCOMPARE(melanin(history), 3.0);
    QVERIFY(!history.canRedo());
  }

  void aNewStepForgetsWhatWasUndone() {
    UndoHistory history;
    history.push("one", {}, withMelanin(2.0));
    history.undo();
    history.push("other", {}, withMelanin(4.0));
    QVERIFY(!history.canRedo());
    QCOMPARE(melanin(history), 4.0);
  }

  void aGroupIsOneStepUntilItIsClosed() {
    UndoHistory history;
    history.push("to 1.1", "melanin", withMelanin(1.1));
    history.push("to 1.2", "melanin", withMelanin(1.2));
    QCOMPARE(history.undoName(), QString("to 1.2"));
    history.closeGroup();
    history.push("drag", "melanin", withMelanin(1.5));
    history.push("other", "carotene", withMelanin(1.6));
    history.undo();
    QCOMPARE(melanin(history), 1.5);
    history.undo();
    QCOMPARE(melanin(history), 1.2);
    history.undo();
    QVERIFY(!history.canUndo());
  }

  void nothingMergesIntoAnUndoneStep() {
    UndoHistory history;
    history.push("drag", "melanin", withMelanin(1.1));
    history.push("other", "carotene", withMelanin(1.2));
    history.undo();
    history.push("drag", "melanin", withMelanin(1.3));
    history.undo();
    QCOMPARE(melanin(history), 1.1);
  }
};

CUTIS_TEST(UndoHistoryTest)

}  // namespace
}  // namespace cutis

#include "undo_history_test.moc"
