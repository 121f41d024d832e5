// What is known of places: means over squares, channels against the curve, indices and differences
// of pins.

#include "src/app/document/place_spectra.h"

#include <cmath>
#include <string>
#include <string_view>

#include <QSignalSpy>
#include <QString>
#include <QStringList>
#include <QtTest>

#include "src/app/document/document.h"
#include "src/app/document/methods_text.h"
#include "src/app/document/pin_readings.h"
#include "src/app/document/place_parts.h"
#include "src/app/spectrum_rows.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr int kFitPatienceMs = 120000;

class PlaceSpectraTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    document_.openSample();
    QTRY_VERIFY_WITH_TIMEOUT(document_.isOpen() && document_.isFitted(), kFitPatienceMs);
    QTRY_VERIFY_WITH_TIMEOUT(jobs_.isIdle(), kFitPatienceMs);
  }
  void cleanupTestCase() { jobs_.stopAll(); }

  // And not the spectrum of the mean parameters.
  void aMeanIsThatOfTheSpectra() {
    const SceneSpectra spectra = all();
    const auto mean = spectra.mean(500, 500, 3);
    QVERIFY(mean.has_value());
    QCOMPARE(mean->pixelCount, 9);
    Spectrum sum = Spectrum::Zero();
    ParameterVector parameters = ParameterVector::Zero();
    double measured = 0.0;
    for (int y = 499; y <= 501; ++y) {
      for (int x = 499; x <= 501; ++x) {
        const auto one = spectra.at(x, y);
        sum += one->original;
        parameters += one->originalParameters;
        measured += one->channels.front().measured;
      }
    }
    EXPECT_AT_MOST((mean->original - sum / 9.0).abs().maxCoeff(), 1e-12);
    EXPECT_AT_MOST((mean->originalParameters - parameters / 9.0).abs().maxCoeff(), 1e-9);
    EXPECT_NEAR(mean->channels.front().measured, measured / 9.0, 1e-12);
  }

  // As `cutis-cli spectrum --maps MAPS --at X,Y` writes it.
  void aPinHasTheSpectrumOfTheCommandLine() {
    const Pin pin = {"A", "", 430, 560};
    std::string text;
    const auto keep = [&text](std::string_view part) {
      text += part;
      return Status();
    };
    const Scene& scene = document_.scene();
    EXPECT_OK(
        writeMapSpectra(scene.model, scene.maps, {{{pin.x, pin.y}}, {}}, "maps.exr", keep, {}));
    const QStringList written = QString::fromStdString(text).split('\n')[1].split(',');
    const auto readings = pinReadings(all(), {{pin}, 1, ""}, {});
    EXPECT_OK(readings);
    const Spectrum& shown = readings.value().front().place->original;
    QCOMPARE(written.size(), shown.size() + 2);
    for (Eigen::Index i = 0; i < shown.size(); ++i)
      EXPECT_NEAR(shown[i], written[i + 2].toDouble(), 1e-8);
  }

  // The background of the sample is no skin, and beyond the picture there is nothing.
  void onlyPixelsWithAnEstimateCount() {
    QVERIFY(!all().at(2, 2).has_value());
    QVERIFY(!all().mean(-20, 500, 11).has_value());
    int x = 2;
    while (!all().at(x, 500))
      ++x;
    const auto edge = all().mean(x, 500, 5);
    QVERIFY(edge->pixelCount > 0 && edge->pixelCount < 25);
  }

  // The fit explains its channels within their noise, most of the time.
  void channelsAreNearTheCurve() {
    const auto place = all().at(500, 500);
    QCOMPARE(place->channels.size(), std::size_t{9});
    for (const ChannelReading& channel : place->channels) {
      QVERIFY(channel.deviation > 0.0);
      EXPECT_AT_MOST(std::abs(channel.measured - channel.modelled), 6 * channel.deviation);
      EXPECT_NEAR(channel.extent.effectiveNm, 550, 120);
    }
    QVERIFY(place->deviation && place->parameterDeviation);
    QVERIFY((*place->parameterDeviation > 0.0).all());
    const Band measured = all().measured().value();
    QVERIFY(wavelengthNm(measured.first) > 380 && wavelengthNm(measured.last) < 780);
  }

  void pinsHaveIndicesAndDifferences() {
    PinSet set{{{"A", "", 500, 500}, {"B", "", 300, 620}, {"C", "", 2, 2}}, 3, "A"};
    const auto readings = pinReadings(all(), set, {});
    EXPECT_OK(readings);
    QCOMPARE(readings.value().size(), std::size_t{3});
    const PinReading& first = readings.value()[0];
    EXPECT_NEAR(first.difference.value(), 0.0, 1e-12);
    QVERIFY(readings.value()[1].difference.value() > 0.0);
    QVERIFY(!readings.value()[2].place && !readings.value()[2].difference);
    QVERIFY(std::abs(first.original.typologyAngle) < 90);
    QVERIFY(first.original.melanin > 0);
    EXPECT_NEAR(first.edited.melanin, first.original.melanin, 0);
    set.reference.clear();
    QVERIFY(!pinReadings(all(), set, {}).value()[0].difference);
  }

  void pinsFollowEdits() {
    const PinSet set{{{"A", "", 500, 500}}, 1, ""};
    document_.apply({"melanin",
                     {},
                     [](DocumentState& state) {
                       state.edits.emplace_back();
                       state.edits.front().parameters[kMelanin].scale = 2.0;
                     },
                     false});
    const PinReading reading = pinReadings(all(), set, {}).value().front();
    document_.undo();
    EXPECT_NEAR(reading.place->editedParameters[kMelanin],
                2 * reading.place->originalParameters[kMelanin], 1e-6);
    QVERIFY(reading.edited.melanin > reading.original.melanin);
    QVERIFY(reading.edited.typologyAngle < reading.original.typologyAngle);
  }

  void pinsAreSavedWork() {
    QSignalSpy changed(&document_, &Document::pinsChanged);
    QVERIFY(!document_.isModified());
    document_.setPins({{{"A", "", 5, 5}}, 1, ""});
    QVERIFY(document_.isModified());
    document_.setPins(document_.pins());
    QCOMPARE(changed.count(), 1);
    QCOMPARE(document_.project().pins.pins.size(), std::size_t{1});
    document_.setPins({});
    QVERIFY(!document_.isModified());
  }

  void methodsNameWhatTheyTookForGranted() {
    FitChoice choice = document_.fitChoice();
    choice.noise = {{0.0, 0.02}};
    choice.prior = "/somewhere/children.json";
    choice.fixed[kCarotene] = 0.0;
    const std::string text = methodsText(document_.scene(), choice, "9.8");
    for (const char* words :
         {"Cutis 9.8", "profile skin2026", "rig monitor", "white, white+blue and white+green",
          "0² + (0.02 · value)²", "was children; carotene was held at 0.", "2024"})
      QVERIFY2(text.find(words) != std::string::npos, text.c_str());
    const std::string caption = captionText(document_.scene(), choice, "9.8");
    QVERIFY2(caption.find(" · prior children · Cutis\u00a09.8") != std::string::npos,
             caption.c_str());
    choice.method = FitMethod::network;
    QVERIFY(methodsText(document_.scene(), choice, "9.8").find("network") != std::string::npos);
  }

  // In the visible; in the infrared blood displaces water, which absorbs more.
  void contributionsAreWhatChromophoresTake() {
    const auto place = all().at(500, 500);
    const PlaceParts parts = placeParts(*document_.scene().model, *place);
    QCOMPARE(parts.contributions.size(), std::size_t{4});
    for (const auto& [parameter, contribution] : parts.contributions)
      EXPECT_AT_MOST(-contribution.segment(kVisibleBand.first, kVisibleBand.count()).minCoeff(),
                     1e-9);
    const auto at = [](int nm) { return (nm - kFirstWavelengthNm) / kWavelengthStepNm; };
    const Spectrum& blood = parts.contributions[1].second;
    QVERIFY(parts.contributions[1].first == kHaemoglobinDermal);
    QVERIFY(blood[at(542)] > 5 * blood[at(700)]);
    QVERIFY(parts.epidermis[at(400)] > parts.epidermis[at(700)]);
    QVERIFY((parts.dermis > 0.0).all());
  }

  void lettersAreGivenAgain() {
    PinSet set{{{"A", "", 0, 0}, {"C", "", 0, 0}}, 1, ""};
    QCOMPARE(freeLetter(set), std::string("B"));
    for (int i = 0; i < 24; ++i)
      set.pins.push_back({freeLetter(set), "", 0, 0});
    QCOMPARE(set.pins.back().letter, std::string("Z"));
    QVERIFY(freeLetter(set).empty());
  }

 private:
  SceneSpectra all() const { return {document_.scene(), document_.fitChoice()}; }

  Engine engine_{std::filesystem::path()};
  JobRunner jobs_;
  Document document_{engine_, jobs_};
};

CUTIS_TEST(PlaceSpectraTest)

}  // namespace
}  // namespace cutis

#include "place_spectra_test.moc"
