// Signatures: patient with rounding, and with nothing else.

#include "core/spectra/signature.h"

#include <cmath>

#include <QtTest>

#include "core/base/random.h"
#include "core/spectra/grid.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

Spectrum someSpectrum() {
  Random random(4);
  Spectrum spectrum;
  for (double& value : spectrum)
    value = random.uniform(0.1, 0.9);
  return spectrum;
}

Signature of(const Spectrum& spectrum) {
  return SignatureBuilder()
      .add(std::span<const double>(spectrum.data(), std::size_t{kSampleCount}))
      .signature();
}

class SignatureTest : public QObject {
  Q_OBJECT

 private slots:
  void roundingIsForgiven() {
    const Spectrum spectrum = someSpectrum();
    Random random(5);
    Spectrum rounded = spectrum;
    for (double& value : rounded)
      value *= 1.0 + 1e-13 * (random.uniform() - 0.5);
    QVERIFY((rounded != spectrum).any());
    QVERIFY(alike(of(spectrum), of(rounded)));
  }

  // A change of one thousandth in any one of the samples.
  void aChangeAnywhereShows() {
    const Signature original = of(someSpectrum());
    QCOMPARE(original.size(), std::size_t{kSignatureProbes});
    for (int sample = 0; sample < kSampleCount; ++sample) {
      Spectrum other = someSpectrum();
      other[sample] += 1e-3;
      QVERIFY2(!alike(of(other), original), std::to_string(sample).c_str());
    }
  }

  void numbersAndTextsCount() {
    const auto one = [](double value) { return SignatureBuilder().add(value).signature(); };
    QVERIFY(alike(one(0.0), one(0.0)));
    QVERIFY(alike(one(3e9), one(3e9 * (1.0 + 1e-14))));
    QVERIFY(!alike(one(3e9), one(3e9 * (1.0 + 1e-5))));
    QVERIFY(!alike(one(0.0), one(1e-9)));
    QVERIFY(!alike(one(1.0), one(-1.0)));
    QVERIFY(alike(one(1e300), one(1e300)));
    QVERIFY(!alike(one(std::nan("")), one(std::nan(""))));
    QVERIFY(!alike(one(1.0), SignatureBuilder().add(1.0).add(1.0).signature()));
    const auto text = [](std::string_view words) {
      return SignatureBuilder().add(words).signature();
    };
    QVERIFY(alike(text("fat"), text("fat")));
    QVERIFY(!alike(text("fat"), text("tail")));
    QVERIFY(!alike(text("ab"), text("ba")));
  }
};

CUTIS_TEST(SignatureTest)

}  // namespace
}  // namespace cutis

#include "signature_test.moc"
