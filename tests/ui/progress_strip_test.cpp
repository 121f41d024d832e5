#include "ui/widgets/progress_strip.h"

#include <QProgressBar>
#include <QSignalSpy>
#include <QToolButton>
#include <QtTest>

#include "tests/support/test_registry.h"
#include "tests/ui/ui_test.h"

namespace cutis {
namespace {

QToolButton* button(ProgressStrip& strip, const QString& name) {
  for (QToolButton* found : strip.findChildren<QToolButton*>()) {
    if (found->accessibleName() == name) return found;
  }
  return nullptr;
}

class ProgressStripTest : public test::UiTest {
  Q_OBJECT

 private slots:
  void showsTheJobWhileItRuns() {
    ProgressStrip strip;
    strip.resize(1200, 32);
    strip.show();
    auto* bar = strip.findChild<QProgressBar*>();
    QVERIFY(!bar->isVisible());
    strip.setJob({"Fitting", "haemoglobin", 0.62, 0.3});
    QVERIFY(bar->isVisible() && strip.jobRuns());
    QCOMPARE(bar->value(), 620);
    strip.setJob({"Fitting", "", {}, {}});
    QCOMPARE(bar->maximum(), 0);
    strip.clearJob();
    QVERIFY(!bar->isVisible());
  }

  // People press it for much else than to lose what a job has done.
  void escapeDismissesAndStopsNoJob() {
    ProgressStrip strip;
    strip.resize(1200, 32);
    strip.show();
    strip.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&strip));
    QSignalSpy cancel(&strip, &ProgressStrip::cancelWanted);
    strip.showMessage("The file ends early.", true);
    strip.setJob({"Fitting", "", 0.1, {}});
    QTest::keyClick(&strip, Qt::Key_Escape);
    QCOMPARE(strip.message(), QString());
    QTest::keyClick(&strip, Qt::Key_Escape);
    QCOMPARE(cancel.count(), 0);
    QTest::mouseClick(button(strip, "Cancel"), Qt::LeftButton);
    QCOMPARE(cancel.count(), 1);
  }

  // With everything that it can hold at once.
  void itNeverWidensTheWindow() {
    ProgressStrip strip;
    strip.show();
    strip.setJob({"Fitting a picture with a long name", "haemoglobin of all people", 0.1, 100.0});
    strip.showMessage("/a/folder/with/a/long/name/face.png: the file cannot be written", true);
    strip.setReadout("x 1234 y 1234  Melanin 12.34 %  Blend 0.5  Carotene 0.0012  Blood 1.2 %");
    QVERIFY2(strip.minimumSizeHint().width() <= 560,
             qPrintable(QString::number(strip.minimumSizeHint().width())));
  }

  void errorsStandBeforeNotices() {
    ProgressStrip strip;
    strip.show();
    strip.showMessage("Notice", false);
    strip.showMessage("Error", true);
    strip.showMessage("Later notice", false);
    QCOMPARE(strip.message(), QString("Error"));
    QTest::mouseClick(button(strip, "Dismiss message"), Qt::LeftButton);
    QCOMPARE(strip.message(), QString("Later notice"));
    strip.clearMessages();
    QVERIFY(strip.message().isEmpty());
    QVERIFY(!button(strip, "Dismiss message")->isVisible());
  }

  // An artist exports, makes a mistake, dismisses it: the export is old news.
  void whatWasReadDoesNotReturn() {
    ProgressStrip strip;
    strip.show();
    for (const bool firstIsError : {false, true}) {
      strip.showMessage("First", firstIsError);
      QTest::qWait(1100);
      strip.showMessage("Second", true);
      QCOMPARE(strip.message(), QString("Second"));
      QTest::mouseClick(button(strip, "Dismiss message"), Qt::LeftButton);
      QCOMPARE(strip.message(), QString());
    }
  }

  // Otherwise nobody learns that the second attempt succeeded.
  void aNoticeStandsBeforeAnErrorThatWasRead() {
    ProgressStrip strip;
    strip.show();
    strip.showMessage("Error", true);
    QTest::qWait(1100);
    strip.showMessage("Notice", false);
    QCOMPARE(strip.message(), QString("Notice"));
    QTest::mouseClick(button(strip, "Dismiss message"), Qt::LeftButton);
    QCOMPARE(strip.message(), QString("Error"));
  }

  void whatIsSaidAgainKeepsItsTopic() {
    ProgressStrip strip;
    strip.show();
    strip.showMessage("a.cutis: the file cannot be written", true, "Save");
    strip.showMessage("a.cutis: the file cannot be written", true);
    strip.showMessage("Saved: b.cutis", false, "Save");
    QCOMPARE(strip.message(), QString("Saved: b.cutis"));
    QTest::mouseClick(button(strip, "Dismiss message"), Qt::LeftButton);
    QCOMPARE(strip.message(), QString());
  }

  void ofOneTopicTheNewestIsKept() {
    ProgressStrip strip;
    strip.show();
    strip.showMessage("Fit: cancelled", false, "Fit");
    strip.showMessage("Written: a.png", false, "Export");
    strip.showMessage("Fit: done", false, "Fit");
    QCOMPARE(strip.message(), QString("Fit: done"));
    QTest::mouseClick(button(strip, "Dismiss message"), Qt::LeftButton);
    QCOMPARE(strip.message(), QString("Written: a.png"));
    strip.withdraw("Export");
    QCOMPARE(strip.message(), QString());
  }

  // Errors stay until somebody has seen to them.
  void noticesAgeAndErrorsStay() {
    ProgressStrip strip;
    strip.setNoticeLife(80);
    strip.show();
    strip.showMessage("Written: a.png", false);
    QCOMPARE(strip.message(), QString("Written: a.png"));
    QTRY_COMPARE(strip.message(), QString());
    strip.showMessage("The file ends early.", true);
    QTest::qWait(200);
    QCOMPARE(strip.message(), QString("The file ends early."));
    strip.showMessage("Later notice", false);
    strip.clearMessages();
    // What nobody was shown has not aged.
    strip.setMessagesShown(false);
    strip.showMessage("Elsewhere", false);
    QTest::qWait(200);
    QCOMPARE(strip.message(), QString("Elsewhere"));
    strip.setMessagesShown(true);
    QTRY_COMPARE(strip.message(), QString());
  }

  void timesAreInWords() {
    QCOMPARE(timeLeftText(0.3), QString("less than 1 s left"));
    QCOMPARE(timeLeftText(2.2), QString("3 s left"));
    QCOMPARE(timeLeftText(600), QString("10 min left"));
    QCOMPARE(timeLeftText(7200), QString("2 h left"));
  }
};

CUTIS_TEST(ProgressStripTest)

}  // namespace
}  // namespace cutis

#include "progress_strip_test.moc"
