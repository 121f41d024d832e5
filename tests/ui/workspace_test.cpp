#include "ui/docks/workspace.h"

#include <functional>
#include <memory>

#include <QDockWidget>
#include <QLabel>
#include <QSignalSpy>
#include <QStackedWidget>

#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"

namespace cutis {
namespace {

class Panel : public QWidget {
 public:
  int painted = 0;

  QSize sizeHint() const override { return {200, 150}; }
  QSize minimumSizeHint() const override { return {100, 40}; }

 protected:
  void paintEvent(QPaintEvent*) override { ++painted; }
};

DockDescription row(const QString& id, Qt::DockWidgetArea area) {
  DockDescription dock;
  dock.id = id;
  dock.title = id;
  dock.area = area;
  dock.extent = 240;
  dock.makePanel = [] { return new Panel; };
  return dock;
}

class WorkspaceTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void docksStandAsDescribed() {
    const auto workspace = shown(900);
    QCOMPARE(areaOf(*workspace, "left"), Qt::LeftDockWidgetArea);
    QCOMPARE(areaOf(*workspace, "foot"), Qt::BottomDockWidgetArea);
    QCOMPARE(workspace->dock("left")->width(), 240);
    QCOMPARE(workspace->dock("foot")->height(), 240);
    for (const char* id : {"left", "one", "two", "three", "foot"})
      QVERIFY2(workspace->isInFront(id), id);
    QVERIFY(workspace->dock("two")->y() > workspace->dock("one")->y());
    QVERIFY(workspace->dock("no such") == nullptr);
  }

  void aColumnThatIsTooHighIsTabbed() {
    const auto workspace = shown(400);
    QVERIFY(workspace->isInFront("one"));
    QVERIFY(!workspace->isInFront("two") && !workspace->isInFront("three"));
    workspace->present("three");
    QTRY_VERIFY(workspace->isInFront("three"));
    QVERIFY(!workspace->isInFront("one"));
  }

  // Hidden, behind another one, in front.
  void togglingBringsADockToTheFront() {
    const auto workspace = shown(400);
    QSignalSpy changed(workspace.get(), &Workspace::docksChanged);
    workspace->toggle("two");
    QTRY_VERIFY(workspace->isInFront("two"));
    workspace->toggle("two");
    QTRY_VERIFY(workspace->dock("two")->isHidden());
    workspace->toggle("two");
    QTRY_VERIFY(workspace->isInFront("two"));
    QTRY_VERIFY(!changed.isEmpty());
  }

  void aLayoutIsRestored() {
    QByteArray kept;
    {
      const auto workspace = shown(900);
      workspace->dock("one")->setFloating(true);
      workspace->dock("two")->hide();
      workspace->addDockWidget(Qt::LeftDockWidgetArea, workspace->dock("foot"));
      kept = workspace->saveLayout();
    }
    const auto workspace = shown(900, kept);
    QVERIFY(workspace->dock("one")->isFloating() && workspace->isInFront("one"));
    QVERIFY(workspace->dock("two")->isHidden());
    QCOMPARE(areaOf(*workspace, "foot"), Qt::LeftDockWidgetArea);
  }

  // As in the window, where the start page stood before: the stack holds back updates meanwhile.
  void aDockThatFloatsIsPaintedAfterARestart() {
    QByteArray kept;
    {
      const auto workspace = shown(900);
      workspace->dock("one")->setFloating(true);
      kept = workspace->saveLayout();
    }
    QStackedWidget pages;
    pages.addWidget(new QWidget);
    auto* workspace = made().release();
    pages.addWidget(workspace);
    workspace->restoreLayout(kept);
    pages.resize(1000, 900);
    pages.show();
    QVERIFY(QTest::qWaitForWindowExposed(&pages));
    pages.setCurrentWidget(workspace);
    auto* panel = static_cast<Panel*>(workspace->dock("one")->widget());
    QTRY_VERIFY(workspace->dock("one")->isFloating() && panel->isVisible());
    QVERIFY(panel->updatesEnabled());
    QTRY_VERIFY(panel->painted > 0);
    // And on every way it can go from there.
    for (const auto& step : std::vector<std::function<void()>>{[=] { workspace->toggle("one"); },
                                                               [=] { workspace->toggle("one"); },
                                                               [=] { workspace->resetLayout(); }}) {
      step();
      QTest::qWait(50);
    }
    panel->painted = 0;
    panel->update();
    QTRY_VERIFY(panel->painted > 0);
  }

  // Panels are as high as they want; what is left is below the last.
  void aColumnSettlesAfterEveryChange() {
    const auto workspace = shown(900);
    const int wanted = workspace->dock("one")->sizeHint().height();
    const auto isSettled = [&](const QStringList& docks) {
      for (const QString& id : docks) {
        const int height = workspace->dock(id)->height();
        if (id == docks.last() ? height < wanted : height != wanted) return false;
      }
      return workspace->dock(docks.last())->geometry().bottom() + 1 == workspace->height();
    };
    QTRY_VERIFY(isSettled({"one", "two", "three"}));
    workspace->toggle("three");
    QTRY_VERIFY(isSettled({"one", "two"}));
    workspace->toggle("three");
    QTRY_VERIFY(isSettled({"one", "two", "three"}));
    workspace->dock("two")->setFloating(true);
    QTRY_VERIFY(isSettled({"one", "three"}));
    workspace->dock("two")->setFloating(false);
    QTRY_VERIFY(isSettled({"one", "two", "three"}));
    workspace->resize(1000, 700);
    QTRY_VERIFY(isSettled({"one", "two", "three"}));
    workspace->toggle("one");
    QTRY_VERIFY(isSettled({"two", "three"}));
  }

  void aLayoutOfALargerWindowSettles() {
    QByteArray kept;
    {
      const auto workspace = shown(1300);
      QTRY_VERIFY(workspace->dock("three")->height() > 800);
      kept = workspace->saveLayout();
    }
    const auto workspace = shown(700, kept);
    const int wanted = workspace->dock("one")->sizeHint().height();
    for (const char* id : {"one", "two"})
      QTRY_COMPARE(workspace->dock(id)->height(), wanted);
    QVERIFY(workspace->dock("three")->height() >= wanted);
  }

  void resettingPutsEveryDockBack() {
    const auto workspace = shown(900);
    workspace->dock("one")->setFloating(true);
    workspace->dock("two")->hide();
    workspace->addDockWidget(Qt::LeftDockWidgetArea, workspace->dock("foot"));
    workspace->tabifyDockWidget(workspace->dock("left"), workspace->dock("three"));
    workspace->resetLayout();
    QVERIFY(!workspace->dock("one")->isFloating());
    QCOMPARE(areaOf(*workspace, "foot"), Qt::BottomDockWidgetArea);
    QCOMPARE(areaOf(*workspace, "three"), Qt::RightDockWidgetArea);
    for (const char* id : {"left", "one", "two", "three", "foot"})
      QTRY_VERIFY2(workspace->isInFront(id), id);
    QVERIFY(workspace->dock("three")->y() > workspace->dock("two")->y());
  }

  void whatIsNoLayoutIsIgnored_data() {
    QTest::addColumn<QByteArray>("layout");
    const QByteArray good = shown(900)->saveLayout();
    QByteArray damaged = good;
    damaged[damaged.size() / 2] = static_cast<char>(damaged[damaged.size() / 2] ^ 0x55);
    QByteArray version = good;
    const auto place = version.indexOf("cutis layout") + 12 + 3;  // the last byte of the number
    version[place] = static_cast<char>(version[place] + 1);
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("foreign") << QByteArray(1000, 'x');
    QTest::newRow("of Qt alone") << QMainWindow().saveState();
    QTest::newRow("cut short") << good.left(good.size() - 7);
    QTest::newRow("damaged") << damaged;
    QTest::newRow("of another version") << version;
  }
  void whatIsNoLayoutIsIgnored() {
    QFETCH(QByteArray, layout);
    const auto workspace = shown(900);
    workspace->dock("two")->hide();
    QVERIFY(!workspace->restoreLayout(layout));
    QVERIFY(workspace->dock("two")->isHidden());
    const auto fresh = shown(900, layout);
    for (const char* id : {"left", "one", "two", "three", "foot"})
      QVERIFY2(fresh->isInFront(id), id);
  }

  // As after an update of the program.
  void aDockThatALayoutDoesNotKnowStandsAsDescribed() {
    const auto workspace = shown(1200);
    const QByteArray kept = workspace->saveLayout();
    const auto newer = made();
    newer->add({row("new", Qt::RightDockWidgetArea)});
    QVERIFY(newer->restoreLayout(kept));
    newer->resize(1000, 1200);
    newer->show();
    QTRY_VERIFY(newer->isInFront("new"));
    QCOMPARE(areaOf(*newer, "new"), Qt::RightDockWidgetArea);
  }

  // As after a screen was taken away.
  void noDockFloatsOutOfReach() {
    QByteArray kept;
    {
      const auto workspace = shown(900);
      workspace->dock("one")->setFloating(true);
      workspace->dock("one")->move(-20000, -20000);
      kept = workspace->saveLayout();
    }
    const auto workspace = shown(900, kept);
    const QDockWidget* dock = workspace->dock("one");
    const bool within = dock->screen()->availableGeometry().intersects(dock->frameGeometry());
    QVERIFY(!dock->isFloating() || within);
    QVERIFY(workspace->isInFront("one"));
  }

 private:
  static std::unique_ptr<Workspace> made() {
    auto workspace = std::make_unique<Workspace>(new QLabel("picture"));
    workspace->add({row("left", Qt::LeftDockWidgetArea), row("one", Qt::RightDockWidgetArea),
                    row("two", Qt::RightDockWidgetArea), row("three", Qt::RightDockWidgetArea),
                    row("foot", Qt::BottomDockWidgetArea)});
    return workspace;
  }

  static std::unique_ptr<Workspace> shown(int height, const QByteArray& layout = {}) {
    auto workspace = made();
    workspace->restoreLayout(layout);
    workspace->resize(1000, height);
    workspace->show();
    static_cast<void>(QTest::qWaitForWindowExposed(workspace.get()));
    // The first layout follows the first showing.
    QTest::qWait(50);
    return workspace;
  }

  static Qt::DockWidgetArea areaOf(const Workspace& workspace, const QString& id) {
    return workspace.dockWidgetArea(workspace.dock(id));
  }
};

CUTIS_TEST(WorkspaceTest)

}  // namespace
}  // namespace cutis

#include "workspace_test.moc"
