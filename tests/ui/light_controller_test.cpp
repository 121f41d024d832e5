#include "ui/docks/light_controller.h"

#include <QSignalSpy>
#include <QToolButton>

#include "src/app/views/view_server.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "ui/docks/light_panel.h"
#include "ui/view/view_controller.h"
#include "ui/view/viewport.h"

namespace cutis {
namespace {

using Kind = LightChoice::Kind;

constexpr int kLightPatienceMs = 120000;

class LightControllerTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void aLightShowsTheSkinUnderIt() {
    QSignalSpy changed(&light_, &LightController::changed);
    light_.setLight({"A", "cie1964", Kind::colour});
    QCOMPARE(server_.picture().light, std::string("A"));
    QCOMPARE(server_.picture().observer, std::string("cie1964"));
    QCOMPARE(views_.current(), ViewKind::skin);
    QCOMPARE(changed.count(), 1);
    QVERIFY((panel_.choice() == LightChoice{"A", "cie1964", Kind::colour}));
  }

  // The light is kept while a band is shown.
  void aBandShowsItsView() {
    light_.setLight({"A", "cie1931", Kind::colour});
    light_.setLight({"A", "cie1931", Kind::nearInfrared});
    QCOMPARE(views_.current(), ViewKind::nearInfrared);
    QCOMPARE(server_.picture().light, std::string("A"));
  }

  // A click in the strip of views, say.
  void thePanelFollowsTheView() {
    QSignalSpy changed(&light_, &LightController::changed);
    views_.show(ViewKind::ultraviolet);
    QCOMPARE(light_.light().kind, Kind::ultraviolet);
    QCOMPARE(panel_.choice().kind, Kind::ultraviolet);
    views_.show(ViewKind::melanin);
    QCOMPARE(panel_.choice().kind, Kind::colour);
    QCOMPARE(views_.current(), ViewKind::melanin);
    QCOMPARE(changed.count(), 2);
  }

  // By the segments of the panel.
  void leavingABandGoesBackToTheViewBefore() {
    views_.show(ViewKind::melanin);
    press("Ultraviolet, 300–400 nm");
    QCOMPARE(views_.current(), ViewKind::ultraviolet);
    press("Near infrared, 700–1000 nm");
    QCOMPARE(views_.current(), ViewKind::nearInfrared);
    press("Visible light: colour under a light");
    QCOMPARE(views_.current(), ViewKind::melanin);
  }

 private:
  void press(const QString& name) {
    for (QToolButton* button : panel_.findChildren<QToolButton*>()) {
      if (button->accessibleName() == name) return QTest::mouseClick(button, Qt::LeftButton);
    }
    QFAIL(qPrintable(name));
  }
  void setUp() override {
    if (!document_.isOpen()) {
      panel_.setLights({{"Lights", {"D65", "A"}}});
      panel_.setObservers({"cie1931", "cie1964"});
      light_.attach(panel_);
      document_.openSample();
    }
    QTRY_VERIFY_WITH_TIMEOUT(document_.isOpen() && jobs_.isIdle(), kLightPatienceMs);
    light_.setLight({"D65", "cie1931", Kind::colour});
  }

  Engine engine_{std::filesystem::path()};
  JobRunner jobs_;
  Document document_{engine_, jobs_};
  ViewServer server_{document_, engine_, jobs_};
  Viewport viewport_;
  ViewController views_{document_, server_, viewport_};
  LightPanel panel_;
  LightController light_{server_, views_};
};

CUTIS_TEST(LightControllerTest)

}  // namespace
}  // namespace cutis

#include "light_controller_test.moc"
