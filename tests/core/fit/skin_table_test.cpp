#include "core/fit/table/skin_table.h"

#include <algorithm>
#include <cmath>

#include <QtTest>

#include "core/base/instruction_set.h"
#include "core/base/random.h"
#include "tests/core/fit/fit_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

// A profile with small axes of different lengths: every entry can be checked.
SkinModel smallModel() {
  Profile profile = test::li2024().profile();
  const int samples[] = {3, 2, 7, 5, 4};
  for (std::size_t k = 0; k < profile.axes.size(); ++k)
    profile.axes[k].samples = samples[k];
  return SkinModel(profile);
}

double worstError(const SkinModel& model, const SkinTable& table, const SpectrumRows& rows,
                  std::size_t stride) {
  double worst = 0.0;
  for (std::size_t entry = 0; entry < table.size(); entry += stride) {
    const Eigen::VectorXd exact =
        rows.matrix() * model.reflectance(table.parameters(entry)).matrix();
    for (Eigen::Index k = 0; k < exact.size(); ++k) {
      const double value = double{table.channel(static_cast<int>(k))[entry]};
      worst = std::max(worst, std::abs(value - exact[k]));
    }
  }
  return worst;
}

class SkinTableTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { EXPECT_OK(pinInstructionSet("")); }
  void cleanup() { EXPECT_OK(pinInstructionSet("")); }

  // Paper, supplement A: 51 · 11 · 51 · 4 · 5.
  void hasThePapersSize() {
    QCOMPARE(tableSize(test::li2024().profile().axes), std::size_t{572220});
  }

  void entriesAndSamplesAreInverse() {
    const SkinTable table(test::li2024().profile().axes, 0);
    QCOMPARE(table.size(), std::size_t{572220});
    for (std::size_t entry = 0; entry < table.size(); ++entry) {
      const auto samples = table.samples(entry);
      QCOMPARE(table.entry(samples), entry);
      for (std::size_t k = 0; k < samples.size(); ++k) {
        QVERIFY(samples[k] >= 0 && samples[k] < table.axes()[k].samples);
      }
    }
  }

  // The documented order: melanin, blend, carotene, dermal, epidermal; the last runs fastest.
  void orderIsAsDocumented() {
    const SkinTable table(test::li2024().profile().axes, 0);
    QCOMPARE(table.samples(1)[kHaemoglobinEpidermal], 1);
    QCOMPARE(table.samples(4)[kHaemoglobinDermal], 1);
    QCOMPARE(table.samples(4 * 51)[kCarotene], 1);
    QCOMPARE(table.samples(4 * 51 * 5)[kMelaninBlend], 1);
    QCOMPARE(table.samples(4 * 51 * 5 * 11)[kMelanin], 1);
  }

  void parametersAreTheAxesValues() {
    const SkinTable table(test::li2024().profile().axes, 0);
    const ParameterVector p = table.parameters(table.entry({50, 10, 25, 3, 2}));
    EXPECT_NEAR(p[kMelanin], 0.5, 1e-15);
    EXPECT_NEAR(p[kMelaninBlend], 1.0, 1e-15);
    EXPECT_NEAR(p[kHaemoglobinDermal], 0.5 * 0.125, 1e-15);
    EXPECT_NEAR(p[kHaemoglobinEpidermal], 0.3, 1e-15);
    EXPECT_NEAR(p[kCarotene], 0.01 * 0.125, 1e-15);
  }

  void everyEntryOfASmallTableIsTheModel_data() {
    QTest::addColumn<QString>("instructionSet");
    QTest::addColumn<int>("rowCount");
    for (const char* name : {"scalar", "sse4", "avx2", "avx512"}) {
      for (const int rowCount : {1, 3, 9, 16}) {
        const QString title = QString("%1, %2 rows").arg(name).arg(rowCount);
        QTest::newRow(qPrintable(title)) << name << rowCount;
      }
    }
  }
  void everyEntryOfASmallTableIsTheModel() {
    QFETCH(QString, instructionSet);
    QFETCH(int, rowCount);
    if (!pinInstructionSet(instructionSet.toStdString())) QSKIP("not on this processor");
    const SpectrumRows monitor = responseRows(test::monitorRig());
    SpectrumRows rows(rowCount, kSampleCount);
    for (int k = 0; k < rowCount; ++k)
      rows.row(k) = monitor.row(k % 9);
    const SkinModel model = smallModel();
    const auto table = buildSkinTable(model, rows, {});
    EXPECT_OK(table);
    QCOMPARE(table.value().size(), std::size_t{3 * 2 * 7 * 5 * 4});
    EXPECT_AT_MOST(worstError(model, table.value(), rows, 1), 4e-6);
  }

  void theWholeTableIsTheModel() {
    const SpectrumRows rows =
        searchTableRows(test::monitorRig(), test::light("D65"), test::cie1931());
    // A stride that is coprime to every axis visits all combinations of samples.
    const double worst = worstError(test::li2024(), *test::monitorTable(), rows, 397);
    qInfo("worst error %.2g", worst);
    EXPECT_AT_MOST(worst, 4e-6);
  }

  void theSameForAnyDivisionOfTheWork() {
    const SpectrumRows rows = responseRows(test::albedoRig());
    const SkinModel model = smallModel();
    const auto a = buildSkinTable(model, rows, {});
    const auto b = buildSkinTable(model, rows, {});
    for (int k = 0; k < 3; ++k)
      QVERIFY(a.value().channel(k) == b.value().channel(k));
  }

  void stopsWhenAskedTo() {
    std::stop_source source;
    JobContext context;
    context.stop = source.get_token();
    context.progress = Progress([&](double fraction, const std::string&) {
      if (fraction > 0.1) source.request_stop();
    });
    const SpectrumRows rows = responseRows(test::albedoRig());
    QVERIFY(buildSkinTable(test::li2024(), rows, context).cancelled());
  }

  void progressReachesItsEnd() {
    std::atomic<double> highest = 0.0;
    JobContext context;
    context.progress = Progress([&](double fraction, const std::string&) {
      if (fraction > highest) highest = fraction;
    });
    EXPECT_OK(buildSkinTable(smallModel(), responseRows(test::albedoRig()), context));
    EXPECT_NEAR(highest.load(), 1.0, 0.0);
  }
};

CUTIS_TEST(SkinTableTest)

}  // namespace
}  // namespace cutis

#include "skin_table_test.moc"
