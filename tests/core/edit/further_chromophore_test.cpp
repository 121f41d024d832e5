// A sixth chromophore, bilirubin in the dermis, made here as a row of the table: spectrum, fit of
// spectra and edit know it without a line of the program, and what knows five alone refuses it.

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <vector>

#include <QtTest>

#include "core/edit/edit_stack.h"
#include "core/fit/spectra/free_spectra_fit.h"
#include "core/skin/model/instrument_model.h"
#include "core/skin/response_model.h"
#include "src/files/profiles/profile_file.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr int kBilirubin = kParameterCount;
constexpr double kMost = 0.3;  // g/L: severe jaundice

// Bound to albumin, per g/L: 48,000 L/mol/cm at 460 nm, 584.7 g/mol; every 20 nm from 340.
constexpr std::array kTable = {1.2, 2.0, 4.1, 7.4, 12.6, 17.3, 18.9, 15.2, 7.1, 1.9, 0.3, 0.0};

Spectrum bilirubin() {
  Spectrum spectrum = Spectrum::Zero();
  for (int i = 0; i < kSampleCount; ++i) {
    const double position = (wavelengthNm(i) - 340.0) / 20.0;
    if (position < 0.0 || position >= double(kTable.size() - 1)) continue;
    const auto below = static_cast<std::size_t>(position);
    const double share = position - double(below);
    spectrum[i] = (1.0 - share) * kTable[below] + share * kTable[below + 1];
  }
  return spectrum;
}

Chromophore bilirubinRow() {
  Chromophore row;
  row.name = "bilirubin";
  row.symbol = "C_bil";
  row.unit = "g/L";
  row.layer = SkinLayer::dermis;
  row.absorption = [](const Profile&) { return bilirubin(); };
  row.range = {kMost, 21, 2};
  row.editLaw = EditLaw::byIndex;
  row.priorScale = PriorScale::log;
  return row;
}

Profile withBilirubin(const char* name) {
  Profile profile = loadProfile(name, "test").value();
  profile.further = {bilirubinRow()};
  return profile;
}

// By diffusion and by radiative transfer.
const std::array<std::shared_ptr<const SkinModel>, 2>& models() {
  static const std::array made = {SkinModel::create(withBilirubin("li2024")).value(),
                                  SkinModel::create(withBilirubin("skin2026")).value()};
  return made;
}

std::vector<double> person(double melanin, double bilirubin) {
  return {melanin, 0.6, 0.03, 0.012, 0.001, bilirubin};
}

// 400, 410 … 700 nm, all of them on the grid.
std::vector<double> wavelengths() {
  std::vector<double> nm;
  for (double w = 400.0; w <= 700.0; w += 10.0)
    nm.push_back(w);
  return nm;
}

class FurtherChromophoreTest : public QObject {
  Q_OBJECT

 private slots:
  void aProfileMayHaveIt() {
    for (const auto& model : models()) {
      const Profile& profile = model->profile();
      EXPECT_OK(validate(profile, "test"));
      QCOMPARE(parameterCount(profile), 6);
      QCOMPARE(chromophoreOf(profile, kBilirubin).name, std::string("bilirubin"));
      QCOMPARE(axisOf(profile, kBilirubin).maximum, kMost);
      Profile without = profile;
      without.further.clear();
      QVERIFY(fingerprint(profile) != fingerprint(without));
      Profile more = profile;
      more.further[0].range.maximum *= 2.0;
      QVERIFY(fingerprint(profile) != fingerprint(more));
    }
  }

  void wrongRowsAreRefused() {
    const auto refused = [](const std::string& words, const auto& change) {
      Profile profile = withBilirubin("li2024");
      change(profile.further[0]);
      EXPECT_ERROR(validate(profile, "test"), words);
    };
    refused("'carotene'", [](Chromophore& row) { row.name = "carotene"; });
    refused("''", [](Chromophore& row) { row.name.clear(); });
    refused("bilirubin.absorption", [](Chromophore& row) { row.absorption = nullptr; });
    refused("parameters.bilirubin.maximum", [](Chromophore& row) { row.range.maximum = 0.0; });
    refused("absorption must be positive", [](Chromophore& row) {
      row.absorption = [](const Profile&) { return Spectrum::Constant(-10.0).eval(); };
    });
  }

  // The more of it, the darker, where it absorbs; nowhere else does anything change.
  void spectraFallWithIt() {
    for (const auto& model : models()) {
      const auto five =
          ParameterVector(Eigen::Map<const ParameterVector>(person(0.03, 0.0).data()));
      Spectrum last = model->reflectance(person(0.03, 0.0));
      QVERIFY((last == model->reflectance(five)).all());
      for (double amount = 0.05; amount <= kMost; amount += 0.05) {
        const Spectrum more = model->reflectance(person(0.03, amount));
        for (int i = 0; i < kSampleCount; ++i)
          QVERIFY(bilirubin()[i] > 0.0 ? more[i] < last[i] : more[i] == last[i]);
        last = more;
      }
    }
  }

  void derivativesAreThoseOfTheSpectrum() {
    constexpr double kStep = 1e-6;
    for (const auto& model : models()) {
      const InstrumentModel seen(*model, {0.03, 0.96, 0.4});
      const std::vector<double> at = person(0.05, 0.12);
      for (int sample = 20; sample < kSampleCount; sample += 10) {
        std::array<double, 6> slopes, seenSlopes;
        model->reflectanceAt(sample, at, slopes.data());
        seen.reflectanceAt(sample, at, seenSlopes.data());
        for (std::size_t k = 0; k < slopes.size(); ++k) {
          std::vector<double> above = at, below = at;
          above[k] += kStep;
          below[k] -= kStep;
          const auto difference = [&](const auto& of) {
            return (of.reflectanceAt(sample, above) - of.reflectanceAt(sample, below)) /
                   (2.0 * kStep);
          };
          const double own = difference(*model), measured = difference(seen);
          EXPECT_NEAR(slopes[k], own, 1e-4 * std::max(std::abs(own), 1e-3));
          EXPECT_NEAR(seenSlopes[k], measured, 1e-4 * std::max(std::abs(measured), 1e-3));
        }
      }
    }
  }

  void aFitFindsIt() {
    const std::vector<double> nm = wavelengths();
    for (const auto& model : models()) {
      std::vector<double> spectra, amounts;
      for (const double melanin : {0.01, 0.03, 0.08}) {
        for (const double amount : {0.0, 0.02, 0.1, 0.25}) {
          amounts.push_back(amount);
          for (const double w : nm) {
            const int sample = (static_cast<int>(w) - kFirstWavelengthNm) / kWavelengthStepNm;
            spectra.push_back(model->reflectanceAt(sample, person(melanin, amount)));
          }
        }
      }
      const auto fits = fitSpectra(*model, nm, spectra, {});
      EXPECT_OK(fits);
      for (std::size_t i = 0; i < amounts.size(); ++i) {
        const SpectrumFit& fit = fits.value()[i];
        QCOMPARE(fit.further.size(), std::size_t{1});
        EXPECT_NEAR(fit.further[0], amounts[i], 1e-3 * kMost);
        EXPECT_AT_MOST(fit.rmse, 1e-6);
      }
      // Who leaves it out explains such skin worse.
      Profile five = model->profile();
      five.further.clear();
      const auto without = SkinModel::create(five).value();
      const auto blind = fitSpectra(*without, nm, spectra, {});
      EXPECT_OK(blind);
      QVERIFY(blind.value()[3].rmse > 1e-3);
      QVERIFY(blind.value()[3].further.empty());
    }
  }

  // By its row's law: by index on a quadratic axis, C (1 + (s − 1) √(C / C_max)).
  void anEditScalesIt() {
    const Chromophore row = bilirubinRow();
    ParameterEdit edit;
    edit.scale = 1.5;
    for (const double amount : {0.0, 0.05, 0.12, 0.29}) {
      const double expected = std::min(amount * (1.0 + 0.5 * std::sqrt(amount / kMost)), kMost);
      EXPECT_NEAR(editedValue(edit, row.editLaw, row.range, amount), expected, 1e-15);
    }
    edit.scale = 0.0;
    const double less = editedValue(edit, row.editLaw, row.range, 0.12);
    EXPECT_NEAR(less, 0.12 * (1.0 - std::sqrt(0.4)), 1e-15);
    for (const auto& model : models()) {
      const Spectrum before = model->reflectance(person(0.03, 0.12));
      QVERIFY((model->reflectance(person(0.03, less)) >= before).all());
    }
    edit = {};
    edit.set = 1.0;
    EXPECT_NEAR(editedValue(edit, row.editLaw, row.range, 0.1), kMost, 0.0);
  }

  void whatKnowsFiveRefusesIt() {
    const SpectrumRows rows = SpectrumRows::Ones(1, kSampleCount);
    for (const FreeConstants free : {FreeConstants{}, FreeConstants{true, false}}) {
      const auto response = ResponseModel::create(*models()[0], rows, {free, std::nullopt}, {});
      EXPECT_ERROR(response, "bilirubin");
    }
    const std::vector<double> nm = wavelengths(), spectrum(nm.size(), 0.3);
    EXPECT_ERROR(fitSpectraFreely(*models()[0], nm, spectrum, {true, false}, {}), "bilirubin");
  }

  void threeAreTooManyToFit() {
    Profile profile = withBilirubin("li2024");
    for (const char* name : {"second", "third"}) {
      profile.further.push_back(bilirubinRow());
      profile.further.back().name = name;
    }
    const std::vector<double> nm = wavelengths(), spectrum(nm.size(), 0.3);
    EXPECT_ERROR(fitSpectra(SkinModel(profile), nm, spectrum, {}), "at most two");
  }
};

CUTIS_TEST(FurtherChromophoreTest)

}  // namespace
}  // namespace cutis

#include "further_chromophore_test.moc"
