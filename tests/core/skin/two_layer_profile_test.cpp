// A profile with all that profiles may have, of the form of skin2026, against numbers of its own:
// formulas written out again, and reflectances of another program.

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <QtTest>

#include "core/skin/profile/absorption.h"
#include "core/transport/adding_doubling.h"
#include "src/files/profiles/profile_file.h"
#include "tests/support/expect.h"
#include "tests/support/folders.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr std::array<int, 12> kNm = {300, 350, 414, 450, 500, 542, 576, 600, 700, 850, 970, 1000};

const Profile& twoLayers() {
  static const Profile profile =
      loadProfile(test::sourceFolder() / "tests/support/two_layer_profile.json", "test").value();
  return profile;
}

int indexOf(int nm) {
  return (nm - kFirstWavelengthNm) / kWavelengthStepNm;
}

// A tabulated spectrum between its samples, held at its ends.
double at(const Spectrum& spectrum, double nm) {
  const double position = std::min(std::max((nm - 300.0) / 2.0, 0.0), 350.0);
  const int i = std::min(static_cast<int>(position), 349);
  return spectrum[i] + (position - i) * (spectrum[i + 1] - spectrum[i]);
}

double packagedBlood(const Profile& p, double oxygenation, double radius, double nm) {
  const double q =
      oxygenation * at(p.oxyhaemoglobin, nm) + (1.0 - oxygenation) * at(p.deoxyhaemoglobin, nm);
  return (1.0 - std::exp(-2.0 * q * radius)) / (2.0 * radius);
}

double seenBlood(const Profile& p, double oxygenation, double radius, double nm) {
  double sum = 0.0, total = 0.0;
  for (double other = 300.0; other <= 1000.0; other += 2.0) {
    const double weight = std::exp(-0.5 * std::pow((other - nm) / 4.25, 2));
    sum += weight * packagedBlood(p, oxygenation, radius, other);
    total += weight;
  }
  return sum / total;
}

double carotene(const Profile& p, double nm) {
  double sum = 0.0, total = 0.0;
  for (double other = nm - 24.0 - 80.0; other <= nm - 24.0 + 80.0; other += 2.0) {
    const double weight = std::exp(-0.5 * std::pow((other - nm + 24.0) / 8.0, 2));
    sum += weight * at(p.carotene, other);
    total += weight;
  }
  return 3.0 * sum / total;
}

double baseline(double nm) {
  return 0.0244 + 8.53 * std::exp(-(nm - 154.0) / 66.2);
}

double epidermis(const Profile& p, const ParameterVector& v, double nm) {
  const double eumelanin = 6.6e10 * std::pow(500.0, -3.33) * std::pow(nm / 500.0, -2.0);
  const double pheomelanin = 2.9e14 * std::pow(nm, -4.75);
  const double tissue = baseline(nm) + 1.66 * std::exp(-(nm - 360.0) / 28.0);
  return 0.8 * (v[0] * (v[1] * eumelanin + (1.0 - v[1]) * pheomelanin) +
                v[3] * seenBlood(p, 0.70, 0.004, nm)) +
         v[4] * carotene(p, nm) + (1.0 - v[0] - v[3] - v[4]) * tissue + 0.2 * at(p.water, nm);
}

double dermis(const Profile& p, const ParameterVector& v, double nm) {
  const double fat = 0.78 * 0.0120 * std::exp(-0.5 * std::pow((nm - 920.0) / 22.0, 2));
  return 0.33 * v[2] * seenBlood(p, 0.60, 0.016, nm) + (1.0 - v[2]) * 0.48 * baseline(nm) +
         0.67 * at(p.water, nm) + fat;
}

struct Row {
  ParameterVector parameters;
  std::array<double, 12> reflectance;
};

// Reflectance per flux that enters, by adding-doubling on radiances with other directions (Gauss
// below and Radau points above the critical angle), extrapolated from 16, 24 and 32 of each to
// infinitely many; the difference between two extrapolations is 1e-7.
const std::array<Row, 4> kRows = {{
    {{0, 0, 0, 0, 0},
     {0.044561, 0.218957, 0.518822, 0.608129, 0.673270, 0.702465, 0.715879, 0.720891, 0.719110,
      0.676317, 0.507036, 0.521218}},
    {{0.02, 0.5, 0.02, 0.01, 0.001},
     {0.032367, 0.105479, 0.185091, 0.251735, 0.340350, 0.329436, 0.341337, 0.458342, 0.571417,
      0.577097, 0.458066, 0.473879}},
    {{0.1, 0.7, 0.05, 0.05, 0.002},
     {0.018200, 0.031713, 0.039298, 0.062923, 0.101428, 0.099679, 0.109565, 0.173546, 0.276127,
      0.335306, 0.308052, 0.324413}},
    {{0.25, 0.9, 0.1, 0.02, 0.0005},
     {0.012205, 0.016970, 0.020770, 0.024931, 0.032629, 0.035159, 0.039307, 0.053951, 0.098411,
      0.146974, 0.159482, 0.171935}},
}};

class TwoLayerProfileTest : public QObject {
  Q_OBJECT

 private slots:
  void absorptionIsItsFormulas() {
    const Profile& p = twoLayers();
    const AbsorptionLaw law(p);
    for (const Row& row : kRows) {
      for (int nm = 300; nm <= 1000; nm += 10) {
        const double expected = epidermis(p, row.parameters, nm);
        EXPECT_NEAR(law.at(indexOf(nm), row.parameters).epidermal, expected, 2e-7 * expected);
        const double below = dermis(p, row.parameters, nm);
        EXPECT_NEAR(law.at(indexOf(nm), row.parameters).dermal, below, 1e-12);
      }
    }
  }

  void bloodAndCaroteneMeetTheirSpotValues() {
    const Profile& p = twoLayers();
    const std::array<double, 12> dermal = {20.5649158, 26.7034559, 31.222364,  23.0092389,
                                           9.4532515,  17.9142641, 17.0246932, 4.3489416,
                                           0.4738261,  0.4842066,  0.4630545,  0.3805839};
    const std::array<double, 12> epidermal = {29.5355542, 47.2638437, 106.0497387, 37.1799559,
                                              10.7743984, 24.098947,  22.803533,   4.0155846,
                                              0.3963578,  0.5065905,  0.5043598,   0.4256491};
    const std::array<double, 12> carotenes = {40.4607672,  17.8961915, 56.30155,  132.3158178,
                                              136.3946326, 8.4206919,  0.9380424, 0.0161551,
                                              0.0,         0.0,        0.0,       0.0};
    const Spectrum inDermis = bloodIn(p, p.dermalBlood), inEpidermis = bloodIn(p, p.epidermalBlood);
    const Spectrum moved = 3.0 * shiftedAndSmoothed(p.carotene, 24.0, 8.0);
    for (std::size_t k = 0; k < kNm.size(); ++k) {
      EXPECT_NEAR(inDermis[indexOf(kNm[k])], dermal[k], 1e-6);
      EXPECT_NEAR(inEpidermis[indexOf(kNm[k])], epidermal[k], 1e-6);
      EXPECT_NEAR(moved[indexOf(kNm[k])], carotenes[k], 1e-6);
    }
  }

  void scatteringIsItsFormulas() {
    const Spectrum upper = epidermalScattering(twoLayers()), lower = dermalScattering(twoLayers());
    for (int i = 0; i < kSampleCount; ++i) {
      const double ratio = wavelengthNm(i) / 550.0;
      EXPECT_NEAR(upper[i], 5.2 * std::pow(ratio, -1.25), 1e-12);
      EXPECT_NEAR(lower[i], 4.7 * (0.45 * std::pow(ratio, -4) + 0.55 * std::pow(ratio, -0.71)),
                  1e-12);
    }
  }

  void radiativeTransferMeetsTheCheckValues() {
    const Profile& p = twoLayers();
    const AbsorptionLaw law(p);
    const Spectrum above = epidermalScattering(p), below = dermalScattering(p);
    double worst = 0.0;
    for (const Row& row : kRows) {
      for (std::size_t k = 0; k < kNm.size(); ++k) {
        const int i = indexOf(kNm[k]);
        const LayerPair absorption = law.at(i, row.parameters);
        const std::vector<TransportLayer> skin = {
            {absorption.epidermal, above[i], p.epidermalThicknessMm},
            {absorption.dermal, below[i]}};
        TransportOptions options;
        options.refractiveIndex = p.refractiveIndex;
        const auto transport = layeredTransport(skin, options);
        EXPECT_OK(transport);
        EXPECT_NEAR(transport.value().reflectance, row.reflectance[k], 2e-6);
        worst = std::max(worst, std::abs(transport.value().reflectance - row.reflectance[k]));
      }
    }
    qInfo("within %.2g of the check values", worst);
  }

  void packagingHasItsLimits() {
    EXPECT_NEAR(packagingFactor(0.0, 0.01), 1.0, 0.0);
    EXPECT_NEAR(packagingFactor(50.0, 0.0), 1.0, 0.0);
    EXPECT_NEAR(packagingFactor(1e-9, 1e-2), 1.0 - 1e-11, 1e-15);
    EXPECT_NEAR(packagingFactor(1e4, 1.0), 1.0 / 2e4, 1e-12);
    EXPECT_NEAR(packagingFactor(30.0, 0.02), (1.0 - std::exp(-1.2)) / 1.2, 1e-15);
  }

  void smoothingKeepsWhatIsFlat() {
    const Spectrum flat = Spectrum::Constant(2.5);
    QVERIFY((smoothed(flat, 7.0) - flat).abs().maxCoeff() < 1e-13);
    QVERIFY((shiftedAndSmoothed(flat, -13.0, 7.0) - flat).abs().maxCoeff() < 1e-13);
    const Spectrum line = Spectrum::LinSpaced(300.0, 1000.0);
    QVERIFY((smoothed(line, 0.0) == line).all());
    QVERIFY((shiftedAndSmoothed(line, 0.0, 0.0) == line).all());
    const Spectrum moved = shiftedAndSmoothed(line, 5.0, 0.0);
    EXPECT_NEAR(moved[100], 495.0, 1e-12);
    EXPECT_NEAR(moved[0], 300.0, 0.0);
    EXPECT_NEAR(shiftedAndSmoothed(line, -5.0, 0.0)[350], 1000.0, 0.0);
    // A line keeps its middle, away from the ends.
    EXPECT_NEAR(smoothed(line, 9.0)[175], 650.0, 1e-9);
    EXPECT_NEAR(shiftedAndSmoothed(line, 5.0, 9.0)[175], 645.0, 1e-9);
  }

  // Tables of the paper's model are kept under this name.
  void thePapersModelKeepsItsName() {
    QCOMPARE(fingerprint(test::li2024().profile()),
             std::string("f5f735cbbb4ff9485a83ae857a6461ab"));
    QVERIFY(fingerprint(twoLayers()) != fingerprint(test::li2024().profile()));
  }

  void everyConstantCounts() {
    const std::string original = fingerprint(twoLayers());
    const auto counts = [&](auto change) {
      Profile profile = twoLayers();
      change(profile);
      return fingerprint(profile) != original;
    };
    QVERIFY(counts([](Profile& p) { p.eumelanin.referenceNm += 1; }));
    QVERIFY(counts([](Profile& p) { p.pheomelanin.referenceNm += 1; }));
    QVERIFY(counts([](Profile& p) { p.bloodSmoothingNm += 1; }));
    QVERIFY(counts([](Profile& p) { p.caroteneInSkin.scale += 1; }));
    QVERIFY(counts([](Profile& p) { p.caroteneInSkin.shiftNm += 1; }));
    QVERIFY(counts([](Profile& p) { p.caroteneInSkin.smoothingNm += 1; }));
    QVERIFY(counts([](Profile& p) { p.fat.peak += 1; }));
    QVERIFY(counts([](Profile& p) { p.fat.centreNm += 1; }));
    QVERIFY(counts([](Profile& p) { p.fat.deviationNm += 1; }));
    QVERIFY(counts([](Profile& p) { p.dermalFat += 0.1; }));
    QVERIFY(counts([](Profile& p) { p.epidermalBlood.oxygenation += 0.1; }));
    QVERIFY(counts([](Profile& p) { p.epidermalBlood.vesselRadiusMm += 0.1; }));
    QVERIFY(counts([](Profile& p) { p.dermalBlood.oxygenation += 0.1; }));
    QVERIFY(counts([](Profile& p) { p.dermalBlood.vesselRadiusMm += 0.1; }));
    QVERIFY(counts([](Profile& p) { p.epidermalUltraviolet.amplitude += 1; }));
    QVERIFY(counts([](Profile& p) { p.epidermalUltraviolet.originNm += 1; }));
    QVERIFY(counts([](Profile& p) { p.epidermalUltraviolet.decayNm += 1; }));
    QVERIFY(counts([](Profile& p) { p.epidermalScatteringLaw.mie.referenceNm += 1; }));
    QVERIFY(counts([](Profile& p) { p.epidermalScatteringLaw.rayleigh.referenceNm += 1; }));
    QVERIFY(counts([](Profile& p) { p.dermalBaselineFactor += 0.1; }));
    QVERIFY(counts([](Profile& p) { p.dermalScatteringLaw->mie.coefficient += 1; }));
    QVERIFY(counts([](Profile& p) { p.dermalScatteringLaw->rayleigh.referenceNm += 1; }));
    QVERIFY(counts([](Profile& p) { p.dermalScatteringLaw.reset(); }));
    QVERIFY(counts([](Profile& p) { p.layerOptics = LayerOpticsKind::diffusion; }));
    // The prior does not count.
    QVERIFY(!counts([](Profile& p) { p.prior = {}; }));
  }
};

CUTIS_TEST(TwoLayerProfileTest)

}  // namespace
}  // namespace cutis

#include "two_layer_profile_test.moc"
