#include "core/render/relight.h"

#include <cmath>

#include <QtTest>

#include "core/fit/population.h"
#include "core/skin/model/reflectance_batch.h"
#include "core/skin/profile/parameter_sampling.h"
#include "core/skin/response_model.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using Eigen::Vector3d;

SpectrumRows rowsUnder(const Spectrum& light, ChromaticAdaptation adaptation) {
  return colourRows(light, test::cie1931(), adaptation, test::light("D65"), test::cie1931());
}

Vector3d diffuserUnder(const SpectrumRows& rows) {
  return rows.matrix() * Eigen::VectorXd::Ones(kSampleCount);
}

struct Errors {
  double rms = 0.0;
  double worst = 0.0;
};

// The reduced response against the sum over the whole grid.
Errors errorsOf(const SpectrumRows& rows, const std::vector<ParameterVector>& points) {
  const ResponseModel response(test::li2024(), rows);
  const PixelBuffer<float> parameters = parameterRows<float>(points);
  std::vector<std::vector<float>> out(static_cast<std::size_t>(rows.rows()),
                                      std::vector<float>(points.size()));
  std::vector<float*> pointers;
  for (auto& row : out)
    pointers.push_back(row.data());
  response.evaluate(parameters.rows(), pointers);
  Errors errors;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Eigen::VectorXd exact = rows.matrix() * test::li2024().reflectance(points[i]).matrix();
    for (std::size_t k = 0; k < out.size(); ++k) {
      const double error = std::abs(double{out[k][i]} - exact[static_cast<Eigen::Index>(k)]);
      errors.worst = std::max(errors.worst, error);
      errors.rms += error * error / static_cast<double>(points.size() * out.size());
    }
  }
  errors.rms = std::sqrt(errors.rms);
  return errors;
}

class RelightTest : public QObject {
  Q_OBJECT

 private slots:
  void lights() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"D65", "A", "D50", "FL2", "FL11", "LED_B3", "LED_RGB1",
                             "iset_LCD_Gechic", "Apple_Studio_Display"}) {
      QTest::newRow(name) << name;
    }
  }

  void reducedRelightingIsTheWholeSum_data() { lights(); }
  void reducedRelightingIsTheWholeSum() {
    QFETCH(QString, name);
    const SpectrumRows rows = rowsUnder(test::light(name.toStdString()), ChromaticAdaptation::none);
    const Errors faces = errorsOf(rows, drawPopulation(protocolPopulation(), 1000, 31));
    const Errors box = errorsOf(rows, sampleBox(test::li2024().profile().axes, 1000, 40000));
    qInfo("%s: faces %.2g rms, %.2g worst; whole box %.2g rms, %.2g worst", qPrintable(name),
          faces.rms, faces.worst, box.rms, box.worst);
    EXPECT_AT_MOST(faces.worst, name == "D65" ? 1e-4 : 3e-4);
    EXPECT_AT_MOST(box.worst, 3e-4);
    EXPECT_AT_MOST(faces.rms, 3e-5);
    EXPECT_AT_MOST(box.rms, 1.2e-5);
  }

  void bandsAreTheirMeans_data() {
    QTest::addColumn<int>("from");
    QTest::addColumn<int>("to");
    QTest::newRow("UV") << 300 << 400;
    QTest::newRow("NIR") << 700 << 1000;
    QTest::newRow("visible") << 400 << 700;
    QTest::newRow("narrow") << 540 << 546;
    QTest::newRow("one sample") << 800 << 800;
  }
  void bandsAreTheirMeans() {
    QFETCH(int, from);
    QFETCH(int, to);
    const Band band = bandBetween(from, to);
    const SpectrumRows row = bandRow(band);
    QCOMPARE(static_cast<int>(row.rows()), 1);
    EXPECT_NEAR(row.sum(), 1.0, 1e-14);
    const Spectrum r = test::li2024().reflectance({0.05, 0.5, 0.02, 0.02, 0.001});
    EXPECT_NEAR((row.row(0).transpose() * r).sum(), r.segment(band.first, band.count()).mean(),
                1e-14);
    const Errors errors = errorsOf(row, drawPopulation(protocolPopulation(), 500, 32));
    EXPECT_AT_MOST(errors.worst, 1e-4);
  }

  // Under D65 the perfect diffuser is (1, 1, 1), with or without adaptation.
  void aPerfectDiffuserIsWhiteUnderDaylight() {
    for (const auto adaptation :
         {ChromaticAdaptation::none, ChromaticAdaptation::bradford, ChromaticAdaptation::cat16}) {
      const Vector3d white = diffuserUnder(rowsUnder(test::light("D65"), adaptation));
      QVERIFY((white - Vector3d::Ones()).norm() < 1e-12);
    }
  }

  void adaptationMakesEveryLightWhite_data() { lights(); }
  void adaptationMakesEveryLightWhite() {
    QFETCH(QString, name);
    const Spectrum light = test::light(name.toStdString());
    for (const auto adaptation : {ChromaticAdaptation::bradford, ChromaticAdaptation::cat16}) {
      const Vector3d white = diffuserUnder(rowsUnder(light, adaptation));
      QVERIFY((white - Vector3d::Ones()).norm() < 1e-12);
    }
  }

  // Without it the light's colour stays, at luminance 1.
  void withoutAdaptationALightKeepsItsColour_data() { lights(); }
  void withoutAdaptationALightKeepsItsColour() {
    QFETCH(QString, name);
    const Spectrum light = test::light(name.toStdString());
    const Vector3d rgb = diffuserUnder(rowsUnder(light, ChromaticAdaptation::none));
    const Vector3d xyz = xyzFromRec709(test::daylightWhite()) * rgb;
    QVERIFY((xyz - whitePoint(light, test::cie1931())).norm() < 1e-12);
    EXPECT_NEAR(xyz[1], 1.0, 1e-12);
    if (name == "A") QVERIFY(rgb[0] > 1.5 && rgb[2] < 0.4);  // reddish
  }

  // Another observer is adapted from the white that it sees itself.
  void otherObserversAndCameras() {
    Sensor tenDegrees = test::cie1931();
    tenDegrees.sensitivity.row(2) *= 1.1;
    for (const auto adaptation : {ChromaticAdaptation::bradford, ChromaticAdaptation::cat16}) {
      const SpectrumRows rows =
          colourRows(test::light("A"), tenDegrees, adaptation, test::light("D65"), test::cie1931());
      QVERIFY((diffuserUnder(rows) - Vector3d::Ones()).norm() < 1e-12);
    }
  }

  // The strength of the light is none of the picture's business.
  void scaleDoesNotMatter() {
    const SpectrumRows once = rowsUnder(test::light("A"), ChromaticAdaptation::cat16);
    const SpectrumRows more = rowsUnder(55.0 * test::light("A"), ChromaticAdaptation::cat16);
    QVERIFY((once - more).abs().maxCoeff() < 1e-14);
  }

  // Relighting adds: a mix of two lights of equal luminance is the mean of their pictures.
  void lightAdds() {
    const auto luminance = [](const Spectrum& light) {
      return (light * test::cie1931().sensitivity.row(1).transpose()).sum();
    };
    const Spectrum a = test::light("A") / luminance(test::light("A"));
    const Spectrum b = test::light("LED_B3") / luminance(test::light("LED_B3"));
    const SpectrumRows mixed = rowsUnder(a + b, ChromaticAdaptation::none);
    const SpectrumRows mean =
        0.5 * (rowsUnder(a, ChromaticAdaptation::none) + rowsUnder(b, ChromaticAdaptation::none));
    QVERIFY((mixed - mean).abs().maxCoeff() < 1e-14);
  }
};

CUTIS_TEST(RelightTest)

}  // namespace
}  // namespace cutis

#include "relight_test.moc"
