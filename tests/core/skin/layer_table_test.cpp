#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stop_token>
#include <vector>

#include <QtTest>

#include "core/base/random.h"
#include "core/skin/layers/table.h"
#include "core/skin/profile/absorption.h"
#include "core/skin/profile/parameter_sampling.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

const Profile& li2024() {
  return test::li2024().profile();
}

// Calibrated profiles come out like this: a thin epidermis over a dermis that scatters more.
Profile thinSkin() {
  Profile profile = li2024();
  profile.epidermalThicknessMm = 0.065;
  profile.dermalScatteringRatio = 2.0;
  return profile;
}

std::vector<int> someSamples() {
  std::vector<int> samples;
  for (int i = 0; i < kSampleCount; i += 10)
    samples.push_back(i);
  return samples;
}

LayerTable tableOf(const Profile& profile, const LayerTableOptions& options = {}) {
  return LayerTable::make(profile, someSamples(), options).value();
}

// C_m .01–.25, β_m .2–1, C_hd .005–.1, C_he 0–.05, C_bc 0–.004: the paper's faces.
std::vector<ParameterVector> faces(int count) {
  const ParameterVector low = {0.01, 0.2, 0.005, 0.0, 0.0}, high = {0.25, 1.0, 0.1, 0.05, 0.004};
  Random random(7);
  std::vector<ParameterVector> people;
  for (int i = 0; i < count; ++i) {
    ParameterVector p;
    for (int k = 0; k < kParameterCount; ++k)
      p[k] = random.uniform(low[k], high[k]);
    people.push_back(p);
  }
  return people;
}

std::vector<ParameterVector> boxWithCorners(int count) {
  std::vector<ParameterVector> points = sampleBox(li2024().axes, count);
  for (int corner = 0; corner < 32; ++corner) {
    ParameterVector p;
    for (int k = 0; k < kParameterCount; ++k) {
      p[k] = (corner >> k & 1) * li2024().axes[static_cast<std::size_t>(k)].maximum;
    }
    points.push_back(p);
  }
  return points;
}

struct Errors {
  double rms = 0.0, worst = 0.0;
};

double direct(const TwoLayers& layers, double epidermal, double dermal,
              const TransportOptions& options) {
  const std::vector<TransportLayer> skin = {
      {epidermal, layers.epidermalScattering, layers.thickness}, {dermal, layers.dermalScattering}};
  return layeredTransport(skin, options).value().reflectance;
}

Errors errorsOf(const Profile& profile, const std::vector<ParameterVector>& points,
                const LayerTableOptions& options = {}) {
  const LayerTable table = tableOf(profile, options);
  const AbsorptionLaw law(profile);
  Errors errors;
  double count = 0.0;
  for (const int sample : table.samples()) {
    const TwoLayers layers = layersOf(profile, sample);
    for (const ParameterVector& p : points) {
      const auto [e, d] = law.at(sample, p);
      const double exact = direct(
          layers, e, d,
          {options.streams, profile.refractiveIndex, options.anisotropy, options.illumination});
      const double error = std::abs(evaluate(table.at(sample), e, d).reflectance - exact);
      errors.worst = std::max(errors.worst, error);
      errors.rms += error * error;
      count += 1.0;
    }
  }
  errors.rms = std::sqrt(errors.rms / count);
  return errors;
}

class LayerTableTest : public QObject {
  Q_OBJECT

 private slots:
  void reproducesAddingDoublingOverTheBox() {
    for (const Profile& profile : {li2024(), thinSkin()}) {
      const Errors box = errorsOf(profile, boxWithCorners(60));
      const Errors people = errorsOf(profile, faces(40));
      qInfo("epidermis %g mm: box %.1e rms, %.1e worst; faces %.1e rms, %.1e worst",
            profile.epidermalThicknessMm, box.rms, box.worst, people.rms, people.worst);
      EXPECT_AT_MOST(box.rms, 1e-5);
      EXPECT_AT_MOST(box.worst, 1e-4);
      EXPECT_AT_MOST(people.rms, 1e-5);
      EXPECT_AT_MOST(people.worst, 1e-4);
    }
  }

  // Whatever a calibration may come to: any thickness, both geometries, forward scattering.
  void holdsForOtherSkins() {
    for (const double thickness : {0.02, 0.05, 0.1, 0.2, 0.5}) {
      Profile profile = li2024();
      profile.epidermalThicknessMm = thickness;
      LayerTableOptions options;
      options.illumination = thickness < 0.1 ? Illumination::diffuse : Illumination::collimated;
      options.anisotropy = thickness == 0.2 ? 0.8 : 0.0;
      const Errors box = errorsOf(profile, sampleBox(profile.axes, 20), options);
      qInfo("epidermis %g mm: box %.1e rms, %.1e worst", thickness, box.rms, box.worst);
      EXPECT_AT_MOST(box.rms, 5e-5);
      EXPECT_AT_MOST(box.worst, 5e-4);
    }
  }

  void slopesAreThoseOfAddingDoubling() {
    const Profile profile = thinSkin();
    const LayerTable table = tableOf(profile);
    for (const int sample : {0, 60, 130, 200, 350}) {
      const TwoLayers layers = layersOf(profile, sample);
      for (const double share : {0.02, 0.1, 0.4}) {
        const auto within = [&](const AbsorptionRange& range) {
          return range.low + share * (range.high - range.low);
        };
        const double e = within(layers.epidermalRange), d = within(layers.dermalRange);
        const LayeredReflectance tabulated = evaluate(table.at(sample), e, d);
        const double stepE = 1e-3 * e, stepD = 1e-3 * d;
        const double perE =
            (direct(layers, e + stepE, d, {}) - direct(layers, e - stepE, d, {})) / (2.0 * stepE);
        const double perD =
            (direct(layers, e, d + stepD, {}) - direct(layers, e, d - stepD, {})) / (2.0 * stepD);
        EXPECT_NEAR(tabulated.perEpidermalAbsorption * e, perE * e, 3e-4);
        EXPECT_NEAR(tabulated.perDermalAbsorption * d, perD * d, 3e-4);
      }
    }
  }

  void derivativesAreThoseOfTheValue() {
    const LayerTable table = tableOf(li2024());
    for (const int sample : table.samples()) {
      const LayerPolynomial<double>& p = table.at(sample);
      for (const double share : {0.001, 0.03, 0.3, 0.9}) {
        const double e = p.epidermis.low + share * (p.epidermis.high - p.epidermis.low);
        const double d = p.dermis.low + share * (p.dermis.high - p.dermis.low);
        const double stepE = 1e-4 * share * e, stepD = 1e-4 * share * d;
        const LayeredReflectance here = evaluate(p, e, d);
        const double perE =
            (evaluate(p, e + stepE, d).reflectance - evaluate(p, e - stepE, d).reflectance) /
            (2.0 * stepE);
        const double perD =
            (evaluate(p, e, d + stepD).reflectance - evaluate(p, e, d - stepD).reflectance) /
            (2.0 * stepD);
        EXPECT_NEAR(here.perEpidermalAbsorption, perE, 1e-4 * std::max(std::abs(perE), 1e-3));
        EXPECT_NEAR(here.perDermalAbsorption, perD, 1e-4 * std::max(std::abs(perD), 1e-3));
      }
    }
  }

  // Absorption darkens, but for a ripple where there is nothing left to darken.
  void reflectanceFalls() {
    const LayerTable table = tableOf(thinSkin());
    for (const int sample : table.samples()) {
      const LayerPolynomial<double>& p = table.at(sample);
      for (const double y : {0.0, 0.5, 1.0}) {
        const double d = p.dermis.low + y * (p.dermis.high - p.dermis.low);
        double before = 1.0;
        for (int i = 0; i <= 200; ++i) {
          const double t = i / 200.0;
          const double e = p.epidermis.low + t * t * (p.epidermis.high - p.epidermis.low);
          const double now = evaluate(p, e, d).reflectance;
          QVERIFY2(now > 0.0 && now < before + 2e-5, qPrintable(QString::number(sample)));
          before = now;
        }
      }
    }
  }

  void edgesGoOn() {
    const LayerTable table = tableOf(li2024());
    const LayerPolynomial<double>& p = table.at(100);
    const double d = p.dermis.low;
    QCOMPARE(evaluate(p, 2.0 * p.epidermis.high, d).reflectance,
             evaluate(p, p.epidermis.high, d).reflectance);
    QCOMPARE(evaluate(p, 0.0, 0.0).reflectance, evaluate(p, p.epidermis.low, d).reflectance);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    QVERIFY(std::isnan(evaluate(p, nan, d).reflectance));
    QVERIFY(std::isnan(evaluate(p, 1.0, nan).perEpidermalAbsorption));
  }

  void aRangeOfNothingIsHarmless() {
    const auto fitted = fitLayerPolynomial({0.1, 8.0, 6.0, {0.0, 0.0}, {0.3, 0.3}});
    EXPECT_OK(fitted);
    EXPECT_NEAR(evaluate(fitted.value(), 1e-4, 0.3).reflectance,
                direct({0.1, 8.0, 6.0, {}, {}}, 1e-4, 0.3, {}), 1e-9);
  }

  // Each wavelength is fitted on its own, whoever computes it and in whatever company.
  void aTableIsItsFits() {
    const LayerTable table = tableOf(li2024());
    for (const int sample : {0, 130, 350}) {
      const auto alone = fitLayerPolynomial(layersOf(li2024(), sample));
      QCOMPARE(std::memcmp(&alone.value(), &table.at(sample), sizeof alone.value()), 0);
    }
    QVERIFY(!table.contains(1));
    const LayerTable restored = LayerTable::restore(table.samples(), table.polynomials());
    QCOMPARE(std::memcmp(&restored.at(200), &table.at(200), sizeof table.at(200)), 0);
  }

  void theFingerprintNamesWhatMatters() {
    const std::string usual = layerTableFingerprint(li2024());
    QCOMPARE(layerTableFingerprint(li2024()), usual);
    QVERIFY(layerTableFingerprint(thinSkin()) != usual);
    QVERIFY(layerTableFingerprint(li2024(), {.streams = 32}) != usual);
    QVERIFY(layerTableFingerprint(li2024(), {.illumination = Illumination::diffuse}) != usual);
  }

  void refusesWhatIsNoSkin() {
    EXPECT_ERROR(fitLayerPolynomial({0.1, 8.0, 6.0, {2.0, 1.0}, {0.1, 1.0}}), "not reversed");
    EXPECT_ERROR(fitLayerPolynomial({0.1, 0.0, 6.0, {0.1, 1.0}, {0.1, 1.0}}), "must be positive");
    const std::vector<int> samples = {125};
    EXPECT_ERROR(LayerTable::make(li2024(), samples, {.streams = 5}), "at 550 nm");
  }

  void stopsWhenTold() {
    std::stop_source source;
    source.request_stop();
    JobContext context;
    context.stop = source.get_token();
    QVERIFY(LayerTable::makeWhole(li2024(), {}, context).cancelled());
  }
};

CUTIS_TEST(LayerTableTest)

}  // namespace
}  // namespace cutis

#include "layer_table_test.moc"
