// What a profile says of its discrepancy is read as it was written; skin2026b is skin2026 in
// everything else.

#include "src/files/profiles/discrepancy_file.h"

#include <sstream>

#include <QtTest>

#include "core/skin/profile/profile.h"
#include "src/files/profiles/profile_edit.h"
#include "src/files/profiles/profile_file.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr double kLastDigit = 0.51e-5;

// Straight between 400, 500 and 900 nm.
Spectrum bent(double height) {
  Spectrum spectrum;
  for (int i = 0; i < kSampleCount; ++i) {
    const double wavelength = wavelengthNm(i);
    spectrum[i] = wavelength < 400.0 || wavelength > 900.0 ? 0.0
                  : wavelength < 500.0                     ? height * (wavelength - 400.0) / 100.0
                                                           : height * (900.0 - wavelength) / 400.0;
  }
  return spectrum;
}

Discrepancy made() {
  Discrepancy discrepancy;
  discrepancy.mean = bent(-0.05);
  discrepancy.components.resize(int{kSampleCount}, 2);
  discrepancy.components << bent(0.02).matrix(), bent(-0.03).matrix();
  discrepancy.slope = Eigen::MatrixXd::Constant(2, kParameterCount, 0.25);
  discrepancy.slope(1, 3) = -12.5;
  discrepancy.covariance = Eigen::MatrixXd::Identity(2, 2);
  discrepancy.covariance(0, 1) = discrepancy.covariance(1, 0) = -0.5;
  discrepancy.rest = bent(0.01).matrix();
  discrepancy.independentDeviation = bent(0.004);
  discrepancy.prior = loadProfile("skin2026", "").value().prior;
  return discrepancy;
}

std::vector<std::string> linesOf(const std::string& profile) {
  std::istringstream text(profileText(profile, "").value());
  std::vector<std::string> lines;
  for (std::string line; std::getline(text, line);) {
    if (line.ends_with(",")) line.pop_back();
    lines.push_back(line);
  }
  return lines;
}

class DiscrepancyFileTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void whatIsWrittenIsRead() {
    const Discrepancy written = made();
    ProfileEdits edits;
    edits.discrepancies.surfaceRemoved = written;
    const auto read =
        parseProfile(editedProfile(profileText("skin2026", "").value(), edits), "made");
    EXPECT_OK(read);
    QVERIFY(!read.value().discrepancies.surfaceIncluded);
    QVERIFY(read.value().discrepancies.of(SurfaceLight::removed) != nullptr);
    const Discrepancy& again = *read.value().discrepancies.surfaceRemoved;
    EXPECT_NEAR((again.mean - written.mean).abs().maxCoeff(), 0.0, kLastDigit);
    EXPECT_NEAR((again.components - written.components).cwiseAbs().maxCoeff(), 0.0, kLastDigit);
    EXPECT_NEAR((again.rest - written.rest).cwiseAbs().maxCoeff(), 0.0, kLastDigit);
    EXPECT_NEAR((again.independentDeviation - written.independentDeviation).abs().maxCoeff(), 0.0,
                kLastDigit);
    QVERIFY(again.slope == written.slope);
    QVERIFY(again.covariance == written.covariance);
    QVERIFY((again.prior.mean == written.prior.mean).all());
    QVERIFY(again.prior.correlation == written.prior.correlation);
  }

  void whatIsWrongIsTold_data() {
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::addColumn<QString>("part");
    QTest::newRow("misspelt") << "\"slope\""
                              << "\"slop\""
                              << "slop";
    QTest::newRow("no covariance") << "-0.5"
                                   << "-1.5"
                                   << "surface_included.covariance";
    QTest::newRow("less than none") << "\"independent_deviation\": [0.0, "
                                    << "\"independent_deviation\": [-0.1, "
                                    << "surface_included.independent_deviation";
    QTest::newRow("short") << "\"mean\": [0.0, "
                           << "\"mean\": ["
                           << "surface_included.mean";
  }
  void whatIsWrongIsTold() {
    QFETCH(QString, from);
    QFETCH(QString, to);
    QFETCH(QString, part);
    ProfileEdits edits;
    edits.discrepancies.surfaceIncluded = made();
    QString text =
        QString::fromStdString(editedProfile(profileText("skin2026", "").value(), edits));
    const auto field = text.indexOf("\"discrepancy\"");
    QVERIFY(text.indexOf(from, field) > 0);
    text = text.left(field) + text.mid(field).replace(from, to);
    const auto read = parseProfile(text.toStdString(), "made");
    QVERIFY(read.failed());
    QVERIFY2(read.error().text().find(part.toStdString()) != std::string::npos,
             read.error().text().c_str());
  }

  // Line by line, but for what it is called and where the discrepancy is from.
  void skin2026bIsSkin2026WithADiscrepancy() {
    const auto before = linesOf("skin2026"), after = linesOf("skin2026b");
    std::size_t same = 0;
    while (same < before.size() && before[same].find("\"sources\"") == std::string::npos) {
      const bool named = before[same].find("\"name\"") != std::string::npos ||
                         before[same].find("\"description\"") != std::string::npos;
      if (!named) QCOMPARE(after[same], before[same]);
      ++same;
    }
    QVERIFY(same > 50);
    for (; before[same] != "  }"; ++same)
      QCOMPARE(after[same], before[same]);
    QCOMPARE(same, before.size() - 2);

    const Profile old = loadProfile("skin2026", "").value();
    Profile profile = loadProfile("skin2026b", "").value();
    for (const SurfaceLight surface : {SurfaceLight::included, SurfaceLight::removed})
      QVERIFY(profile.discrepancies.of(surface) != nullptr);
    profile.discrepancies = {};
    QCOMPARE(fingerprint(profile), fingerprint(old));
    QVERIFY((profile.prior.mean == old.prior.mean).all());
    QVERIFY((profile.prior.deviation == old.prior.deviation).all());
    QVERIFY(profile.prior.correlation == old.prior.correlation);
  }
};

CUTIS_TEST(DiscrepancyFileTest)

}  // namespace
}  // namespace cutis

#include "discrepancy_file_test.moc"
