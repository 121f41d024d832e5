// What maps say of their fit is read as it was written, and what cannot be is refused.

#include "src/files/profiles/fit_record_file.h"

#include <QtTest>

#include "src/files/profiles/profile_file.h"
#include "src/files/rig_file.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
// Its own, since tests of a folder are compiled together.
namespace fit_record_file {
namespace {

const Profile& profile() {
  static const Profile loaded = loadProfile("skin2026b", "test").value();
  return loaded;
}

FitRecord record() {
  FitOptions options;
  options.noise = NoiseModel{0.0002, 0.01, 0.03};
  options.fixed[kCarotene] = 0.001;
  options.shading = 0.2;
  return fitRecord(profile(), loadRig("monitor", "", "test").value(), options);
}

class FitRecordFileTest : public QObject {
  Q_OBJECT

 private slots:
  void comesBackAsItWasWritten() {
    const FitRecord written = record();
    QVERIFY(written.discrepancy);
    const std::string text = fitRecordText(written);
    QVERIFY(text.find('\n') == std::string::npos);
    const auto parsed = parseFitRecord(text, profile(), "maps");
    EXPECT_OK(parsed);
    const FitRecord& read = parsed.value();
    QVERIFY(read.lights == (std::vector<std::string>{"white", "white+blue", "white+green"}));
    QVERIFY(read.channels == written.channels);
    QCOMPARE(read.channels.front(), std::string("white.R"));
    QVERIFY(((read.responses - written.responses).abs() <= 1e-8).all());
    QCOMPARE(read.noise.read, 0.0002);
    QCOMPARE(read.noise.proportional, 0.01);
    QCOMPARE(read.noise.veil, 0.03);
    QVERIFY((read.prior.mean == written.prior.mean).all());
    QVERIFY((read.prior.deviation == written.prior.deviation).all());
    QVERIFY(read.prior.correlation == written.prior.correlation);
    QVERIFY(read.prior.isLog(kMelanin) == written.prior.isLog(kMelanin));
    QVERIFY(read.fixed == written.fixed);
    QVERIFY(read.shading == written.shading);
    QVERIFY(read.free == written.free);
    QVERIFY(read.discrepancy);
    QCOMPARE(fitRecordText(read), text);
  }

  void whatCannotBeIsRefused_data() {
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::addColumn<QString>("words");
    QTest::newRow("noise") << "\"read\":0.0002"
                           << "\"read\":-1"
                           << "noise must be 0 or more";
    QTest::newRow("held") << "{\"carotene\":0.001}"
                          << "{\"carotene\":7}"
                          << "held parameter";
    QTest::newRow("surface") << "\"specular\":\"included\""
                             << "\"specular\":\"some\""
                             << "included";
    QTest::newRow("version") << "\"cutis_fit\":1"
                             << "\"cutis_fit\":2"
                             << "newer";
    QTest::newRow("shading") << "\"shading\":0.2"
                             << "\"shading\":0"
                             << "shading must be positive";
  }
  void whatCannotBeIsRefused() {
    QFETCH(QString, from);
    QFETCH(QString, to);
    QFETCH(QString, words);
    QString text = QString::fromStdString(fitRecordText(record()));
    QVERIFY(text.contains(from));
    text.replace(from, to);
    EXPECT_ERROR(parseFitRecord(text.toStdString(), profile(), "maps"), words.toUtf8().constData());
  }

  void aDiscrepancyThatTheProfileDoesNotKnowIsRefused() {
    const Profile other = loadProfile("skin2026", "test").value();
    EXPECT_ERROR(parseFitRecord(fitRecordText(record()), other, "maps"), "does not know");
  }
};

CUTIS_TEST(FitRecordFileTest)

}  // namespace
}  // namespace fit_record_file
}  // namespace cutis

#include "fit_record_file_test.moc"
