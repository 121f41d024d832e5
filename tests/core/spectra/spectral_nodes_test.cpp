#include "core/spectra/spectral_nodes.h"

#include <algorithm>
#include <cmath>

#include <QtTest>

#include "core/skin/profile/parameter_sampling.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

SpectrumRows spectra(int count, int first) {
  SpectrumRows rows(count, kSampleCount);
  const auto points = sampleBox(test::li2024().profile().axes, count, first);
  for (int i = 0; i < count; ++i) {
    rows.row(i) = test::li2024().reflectance(points[static_cast<std::size_t>(i)]).transpose();
  }
  return rows;
}

const SpectrumRows& training() {
  static const SpectrumRows rows = spectra(1000, 0);
  return rows;
}
const SpectrumRows& checking() {
  static const SpectrumRows rows = spectra(500, 1000);
  return rows;
}

// Errors of the nodes' sums against the whole ones.
Eigen::MatrixXd errors(const SpectralNodes& nodes, const SpectrumRows& rows,
                       const SpectrumRows& over) {
  Eigen::MatrixXd picked(over.rows(), static_cast<Eigen::Index>(nodes.samples.size()));
  for (std::size_t n = 0; n < nodes.samples.size(); ++n) {
    picked.col(static_cast<Eigen::Index>(n)) = over.col(nodes.samples[n]).matrix();
  }
  return picked * nodes.weights.transpose() - over.matrix() * rows.matrix().transpose();
}

double rms(const Eigen::MatrixXd& e) {
  return std::sqrt(e.squaredNorm() / static_cast<double>(e.size()));
}

SpectrumRows bandRows() {
  SpectrumRows rows = SpectrumRows::Zero(2, kSampleCount);
  rows.row(0).head(51) = 1.0 / 51.0;
  rows.row(1).tail(151) = 1.0 / 151.0;
  return rows;
}

class SpectralNodesTest : public QObject {
  Q_OBJECT

 private slots:
  void reproducesWhatItNeverSaw() {
    const SpectrumRows rows = responseRows(test::monitorRig());
    const SpectralNodes nodes = chooseSpectralNodes(rows, training(), checking());
    const Eigen::MatrixXd unseen = errors(nodes, rows, spectra(1500, 100000));
    qInfo("%zu nodes: rms %.2g at choosing, %.2g unseen, worst %.2g", nodes.samples.size(),
          nodes.rmsError, rms(unseen), unseen.cwiseAbs().maxCoeff());
    EXPECT_AT_MOST(rms(unseen), 1.3e-5);
    EXPECT_AT_MOST(unseen.cwiseAbs().maxCoeff(), 3e-4);
  }

  void theMonitorRigNeedsTwelve() {
    const SpectralNodes nodes =
        chooseSpectralNodes(responseRows(test::monitorRig()), training(), checking());
    EXPECT_AT_MOST(nodes.rmsError, 1e-5);
    EXPECT_AT_MOST(static_cast<double>(nodes.samples.size()), 12.0);
  }

  void saysWhatItReaches() {
    const SpectrumRows rows = responseRows(test::monitorRig());
    const SpectralNodes nodes = chooseSpectralNodes(rows, training(), checking(), {1e-4, 40});
    const Eigen::MatrixXd e = errors(nodes, rows, checking());
    EXPECT_NEAR(nodes.rmsError, rms(e), 1e-12);
    EXPECT_NEAR(nodes.worstError, e.cwiseAbs().maxCoeff(), 1e-12);
    EXPECT_AT_MOST(nodes.rmsError, 1e-4);
  }

  void tooFewNodesAreSaidToBeTooFew() {
    const SpectrumRows rows = responseRows(test::monitorRig());
    const SpectralNodes nodes = chooseSpectralNodes(rows, training(), checking(), {1e-5, 4});
    QCOMPARE(nodes.samples.size(), std::size_t{4});
    QVERIFY(nodes.rmsError > 1e-5);
    EXPECT_NEAR(nodes.rmsError, rms(errors(nodes, rows, checking())), 1e-12);
  }

  // Choosing stops at the first count that meets the tolerance, and each more node helps.
  void moreNodesAreBetter() {
    const SpectrumRows rows = responseRows(test::monitorRig());
    double last = 1.0;
    for (const int count : {2, 4, 6, 8, 10}) {
      const SpectralNodes nodes = chooseSpectralNodes(rows, training(), checking(), {0.0, count});
      QCOMPARE(nodes.samples.size(), static_cast<std::size_t>(count));
      QVERIFY(nodes.rmsError < last);
      last = nodes.rmsError;
    }
  }

  void samplesAreOnTheGridAndIncrease() {
    const SpectralNodes nodes =
        chooseSpectralNodes(responseRows(test::monitorRig()), training(), checking());
    QVERIFY(std::is_sorted(nodes.samples.begin(), nodes.samples.end()));
    QVERIFY(std::adjacent_find(nodes.samples.begin(), nodes.samples.end()) == nodes.samples.end());
    QVERIFY(nodes.samples.front() >= 0 && nodes.samples.back() < kSampleCount);
    QCOMPARE(nodes.weights.rows(), Eigen::Index{9});
    QCOMPARE(nodes.weights.cols(), static_cast<Eigen::Index>(nodes.samples.size()));
  }

  // Nodes only where some row looks: a view without UV evaluates none there.
  void onlyWavelengthsInUse() {
    const SpectralNodes nodes = chooseSpectralNodes(bandRows(), training(), checking());
    for (const int sample : nodes.samples)
      QVERIFY(sample <= 50 || sample >= 200);
    EXPECT_AT_MOST(rms(errors(nodes, bandRows(), spectra(300, 5000))), 1.3e-5);
  }

  void theSameEveryTime() {
    const SpectrumRows rows = responseRows(test::albedoRig());
    const SpectralNodes a = chooseSpectralNodes(rows, training(), checking());
    const SpectralNodes b = chooseSpectralNodes(rows, training(), checking());
    QVERIFY(a.samples == b.samples);
    QVERIFY(a.weights == b.weights);
  }

  void aDeadRowStaysDead() {
    SpectrumRows rows = responseRows(test::albedoRig());
    rows.row(1).setZero();
    const SpectralNodes nodes = chooseSpectralNodes(rows, training(), checking());
    QVERIFY(nodes.weights.row(1).isZero(0.0));
    EXPECT_AT_MOST(nodes.rmsError, 1e-5);
    EXPECT_AT_MOST(rms(errors(nodes, rows, checking())), 1e-5);
  }

  // A rig whose camera sees nothing under its lights.
  void nothingToSeeNeedsNoNodes() {
    const SpectrumRows rows = SpectrumRows::Zero(3, kSampleCount);
    const SpectralNodes nodes = chooseSpectralNodes(rows, training(), checking());
    QVERIFY(nodes.samples.empty());
    QCOMPARE(nodes.weights.rows(), Eigen::Index{3});
    QCOMPARE(nodes.weights.cols(), Eigen::Index{0});
    EXPECT_NEAR(nodes.rmsError, 0.0, 0.0);
  }

  void oneWavelengthIsItself() {
    SpectrumRows rows = SpectrumRows::Zero(1, kSampleCount);
    rows(0, 77) = 2.5;
    const SpectralNodes nodes = chooseSpectralNodes(rows, training(), checking());
    QVERIFY(nodes.samples == std::vector<int>{77});
    EXPECT_NEAR(nodes.weights(0, 0), 2.5, 1e-12);
  }
};

CUTIS_TEST(SpectralNodesTest)

}  // namespace
}  // namespace cutis

#include "spectral_nodes_test.moc"
