#include "ui/view/viewport.h"

#include <cmath>
#include <memory>

#include <QPainter>
#include <QSignalSpy>
#include <QWheelEvent>
#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"
#include "ui/color/color_bar.h"

namespace cutis {
namespace {

constexpr int kWidth = 1600;
constexpr int kHeight = 1200;

void turnWheel(QWidget& widget, const QPointF& place, int notches) {
  QWheelEvent event(place, widget.mapToGlobal(place), {}, {0, 120 * notches}, Qt::NoButton,
                    Qt::NoModifier, Qt::NoScrollPhase, false);
  QApplication::sendEvent(&widget, &event);
}

class ViewportTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void fitsANewPicture() {
    // 824 − 2 · 12 of margin for 1600 pixels.
    EXPECT_NEAR(view_->zoom(), 0.5, 1e-9);
    QVERIFY((view_->visibleRect() == Rect{0, 0, kWidth, kHeight}));
    QCOMPARE(view_->samplingStep(), 2);
  }

  void tellsOfANewPicture() {
    view_->setPictureSize(kWidth, kHeight);
    QCOMPARE(moved_->count(), 1);
    view_->clear();
    QCOMPARE(moved_->count(), 2);
    QVERIFY(moved_->last()[0].value<Rect>().empty());
  }

  // However long and narrow it is, and whichever way it lies.
  void somethingIsSeenOfAnyPicture() {
    for (const QSize size : {QSize(1, 32768), QSize(32768, 1), QSize(3, 30000), QSize(1, 1)}) {
      view_->setPictureSize(size.width(), size.height());
      const double thinner = std::min(size.width(), size.height()) * view_->zoom();
      QVERIFY2(thinner >= 4.0, qPrintable(QString::number(thinner)));
      const Rect seen = view_->visibleRect();
      QVERIFY(!seen.empty());
      const QPointF middle = view_->toImage(QPointF(view_->rect().center()));
      QVERIFY(std::abs(middle.x() - size.width() / 2.0) <= 1.0);
      QVERIFY(std::abs(middle.y() - size.height() / 2.0) <= 1.0);
    }
  }

  void staysFittedWhenResized() {
    view_->resize(424, 624);
    QTRY_COMPARE(view_->width(), 424);
    EXPECT_NEAR(view_->zoom(), 0.25, 1e-9);
    QVERIFY(view_->fitted());
    QCOMPARE(moved_->last()[1].toInt(), 4);
  }

  void wheelKeepsThePointUnderTheCursor() {
    const QPointF place(200, 500);
    const QPointF before = view_->toImage(place);
    for (int i = 0; i < 12; ++i) {
      turnWheel(*view_, place, 1);
      const QPointF drift = (view_->toImage(place) - before) * view_->zoom();
      // At 1 : 1 the picture lies on whole device pixels.
      EXPECT_AT_MOST(std::hypot(drift.x(), drift.y()), 1.0);
    }
    QVERIFY(view_->zoom() > 4);
  }

  void wheelHaltsAtOneToOne() {
    bool halted = false;
    for (int i = 0; i < 8; ++i) {
      turnWheel(*view_, {400, 300}, 1);
      halted = halted || view_->zoom() == 1.0;
    }
    QVERIFY(halted);
  }

  void zoomHasLimits() {
    for (int i = 0; i < 60; ++i)
      turnWheel(*view_, {400, 300}, 1);
    EXPECT_NEAR(view_->zoom(), 64, 1e-9);
    for (int i = 0; i < 120; ++i)
      turnWheel(*view_, {400, 300}, -1);
    EXPECT_NEAR(view_->zoom(), 0.5 / 8, 1e-9);
    QCOMPARE(view_->samplingStep(), 16);
  }

  void fitsAndShowsOneToOne() {
    view_->zoomOneToOne();
    EXPECT_NEAR(view_->zoom(), 1, 0);
    QVERIFY(!view_->fitted());
    QCOMPARE(view_->samplingStep(), 1);
    QCOMPARE(view_->visibleRect().width(), 824);
    view_->fitPicture();
    EXPECT_NEAR(view_->zoom(), 0.5, 1e-9);
    QVERIFY(view_->fitted());
  }

  void oneToOneIsOnePixelPerPixel() {
    view_->zoomOneToOne();
    QImage image(kWidth, kHeight, QImage::Format_RGB32);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x)
        image.setPixel(x, y, qRgb(x & 255, y & 255, (x + y) & 255));
    }
    view_->setDetail(image, {0, 0, kWidth, kHeight}, 1);
    const QImage shown = view_->grab().toImage();
    const Rect visible = view_->visibleRect();
    for (const QPoint& at : {QPoint(0, 0), QPoint(411, 300), QPoint(823, 623)}) {
      QCOMPARE(shown.pixel(at), image.pixel(visible.x0 + at.x(), visible.y0 + at.y()));
    }
  }

  void squaresStaySharpAboveTwo() {
    view_->setPictureSize(2, 1);
    QImage image(2, 1, QImage::Format_RGB32);
    image.setPixel(0, 0, qRgb(255, 0, 0));
    image.setPixel(1, 0, qRgb(0, 0, 255));
    view_->setDetail(image, {0, 0, 2, 1}, 1);
    const QImage shown = view_->grab().toImage();
    const QPoint edge = view_->toWidget({1, 0.5}).toPoint();
    QCOMPARE(shown.pixel(edge - QPoint(2, 0)), qRgb(255, 0, 0));
    QCOMPARE(shown.pixel(edge + QPoint(2, 0)), qRgb(0, 0, 255));
  }

  void theOverviewStandsInUntilDetailComes() {
    QImage overview(16, 12, QImage::Format_RGB32);
    overview.fill(qRgb(10, 200, 30));
    view_->setOverview(overview);
    QCOMPARE(view_->grab().toImage().pixel(412, 312), qRgb(10, 200, 30));
    QImage detail(400, 300, QImage::Format_RGB32);
    detail.fill(qRgb(200, 10, 30));
    view_->setDetail(detail, {0, 0, 800, 600}, 2);
    const QImage shown = view_->grab().toImage();
    QCOMPARE(shown.pixel(view_->toWidget({400, 300}).toPoint()), qRgb(200, 10, 30));
    QCOMPARE(shown.pixel(view_->toWidget({1200, 900}).toPoint()), qRgb(10, 200, 30));
  }

  void middleButtonAndSpacePan() {
    view_->zoomOneToOne();
    const QPointF before = view_->toWidget({0, 0});
    drag(Qt::MiddleButton, {400, 300}, {350, 280});
    QCOMPARE(view_->toWidget({0, 0}) - before, QPointF(-50, -20));
    QTest::keyPress(view_.get(), Qt::Key_Space);
    drag(Qt::LeftButton, {350, 280}, {400, 300});
    QTest::keyRelease(view_.get(), Qt::Key_Space);
    QCOMPARE(view_->toWidget({0, 0}), before);
  }

  void arrowsPanButNeverLoseThePicture() {
    view_->zoomOneToOne();
    const QPointF before = view_->toWidget({0, 0});
    QTest::keyClick(view_.get(), Qt::Key_Right);
    QCOMPARE(view_->toWidget({0, 0}) - before, QPointF(-64, 0));
    for (int i = 0; i < 100; ++i)
      QTest::keyClick(view_.get(), Qt::Key_Right);
    QCOMPARE(view_->visibleRect().width(), 48);
  }

  void visibleRectFollowsTheStep() {
    turnWheel(*view_, {600, 100}, -3);
    const int step = view_->samplingStep();
    QTest::keyClick(view_.get(), Qt::Key_Right);
    drag(Qt::MiddleButton, {400, 300}, {100, 287});
    const Rect visible = moved_->last()[0].value<Rect>();
    QCOMPARE(moved_->last()[1].toInt(), step);
    QVERIFY(visible == view_->visibleRect());
    QCOMPARE(visible.x0 % step, 0);
    QVERIFY(visible.x0 >= 0 && visible.x1 <= kWidth && visible.y1 <= kHeight);
    EXPECT_AT_MOST(1.0, 1 / (view_->zoom() * step));
  }

  void saysNothingWhereNothingChanges() {
    view_->fitPicture();
    QCOMPARE(moved_->count(), 0);
  }

  void tellsThePixelUnderTheCursor() {
    QSignalSpy cursor(view_.get(), &Viewport::cursorMoved);
    QSignalSpy left(view_.get(), &Viewport::cursorLeft);
    QTest::mouseMove(view_.get(), view_->toWidget({801, 601}).toPoint());
    QVERIFY(!cursor.isEmpty());
    EXPECT_NEAR(cursor.last()[0].toInt(), 801, 2);
    EXPECT_NEAR(cursor.last()[1].toInt(), 601, 2);
    QTest::mouseMove(view_.get(), {3, 3});
    QTest::mouseMove(view_.get(), {4, 4});
    QCOMPARE(left.count(), 1);
  }

  void clicksNameAPixelAndDragsDoNot() {
    QSignalSpy clicked(view_.get(), &Viewport::clicked);
    const QPoint place = view_->toWidget({400, 300}).toPoint();
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, place);
    QCOMPARE(clicked.count(), 1);
    EXPECT_NEAR(clicked[0][0].toInt(), 400, 2);
    drag(Qt::LeftButton, place, place + QPoint(60, 0));
    QTest::mouseClick(view_.get(), Qt::LeftButton, {}, {2, 2});
    QCOMPARE(clicked.count(), 1);
  }

  void theColourBarIsDrawn() {
    const QImage without = view_->grab().toImage();
    view_->setColorBar(
        ColorBarSpec{"Melanin", "volume fraction", {0, 0.25}, ScaleKind::sequential, {}, true});
    const QImage with = view_->grab().toImage();
    QVERIFY(without.pixel(40, 580) != with.pixel(40, 580));
    QCOMPARE(without.pixel(600, 100), with.pixel(600, 100));
  }

  // In a window of the smallest size.
  void theColourBarLeavesThePictureInSight_data() {
    QTest::addColumn<QSize>("size");
    for (const QSize size : {QSize(160, 120), QSize(160, 380), QSize(300, 240), QSize(400, 380)})
      QTest::addRow("%d x %d", size.width(), size.height()) << size;
  }
  void theColourBarLeavesThePictureInSight() {
    QFETCH(QSize, size);
    QImage canvas(size, QImage::Format_RGB32);
    QPainter painter(&canvas);
    const QRectF covered =
        drawColorBar(painter, view_->font(), QPointF(0, size.height()), QSizeF(size),
                     ColorBarSpec{"Epidermal haemoglobin",
                                  "volume fraction",
                                  {0, 0.25},
                                  ScaleKind::sequential,
                                  {},
                                  true});
    QVERIFY(covered.width() * covered.height() <= 0.25 * size.width() * size.height());
    QVERIFY(QRectF(QPointF(), QSizeF(size)).contains(covered) || covered.isEmpty());
  }

  void aHiddenPictureIsNotPointedAt() {
    QSignalSpy left(view_.get(), &Viewport::cursorLeft);
    QTest::mouseMove(view_.get(), view_->rect().center());
    view_->hide();
    QCOMPARE(left.count(), 1);
  }

 private:
  void tearDown() override {
    moved_.reset();
    view_.reset();
  }

  void setUp() override {
    view_ = std::make_unique<Viewport>();
    view_->resize(824, 624);
    view_->show();
    QVERIFY(QTest::qWaitForWindowExposed(view_.get()));
    view_->setPictureSize(kWidth, kHeight);
    moved_ = std::make_unique<QSignalSpy>(view_.get(), &Viewport::viewChanged);
  }

  void drag(Qt::MouseButton button, const QPoint& from, const QPoint& to) {
    QTest::mousePress(view_.get(), button, {}, from);
    QTest::mouseMove(view_.get(), (from + to) / 2);
    QTest::mouseMove(view_.get(), to);
    QTest::mouseRelease(view_.get(), button, {}, to);
  }

  std::unique_ptr<Viewport> view_;
  std::unique_ptr<QSignalSpy> moved_;
};

CUTIS_TEST(ViewportTest)

}  // namespace
}  // namespace cutis

#include "viewport_test.moc"
