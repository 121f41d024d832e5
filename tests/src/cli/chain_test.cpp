// simulate → fit → edit → render → apply → info, held against the model in double precision.

#include <cmath>

#include <nlohmann/json.hpp>

#include "core/edit/edit_stack.h"
#include "core/render/relight.h"
#include "core/skin/model/skin_model.h"
#include "src/app/picture_request.h"
#include "src/files/profiles/profile_file.h"
#include "tests/src/cli/program_run.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

Q_DECLARE_METATYPE(cutis::PictureRequest)

namespace cutis::test {
namespace {

constexpr int kChainWidth = 96;
constexpr int kChainHeight = 64;
constexpr std::size_t kPixels = static_cast<std::size_t>(kChainWidth) * kChainHeight;

std::vector<ParameterVector> parametersOf(const ChromophoreMaps& maps) {
  std::vector<ParameterVector> pixels(static_cast<std::size_t>(maps.width()) *
                                      static_cast<std::size_t>(maps.height()));
  for (const Parameter parameter : kParameters) {
    const std::vector<float> values = valuesOf(maps.values[parameter]);
    for (std::size_t i = 0; i < pixels.size(); ++i)
      pixels[i][parameter] = double{values[i]};
  }
  return pixels;
}

const SkinModel& usualModel() {
  static const auto model = SkinModel::create(loadProfile(kDefaultProfile, "test").value()).value();
  return *model;
}

// The full-resolution integral, one value per row.
Eigen::VectorXd seen(const SpectrumRows& rows, const ParameterVector& skin) {
  return rows.matrix() * usualModel().reflectance(skin).matrix();
}

SpectrumRows rowsOf(const PictureRequest& request) {
  return pictureRows(request, {"test", "test"}).value().rows;
}

class ChainTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    EXPECT_DONE(run_.run("simulate --patch 96x64 --noise 0 --seed 3 -o cap"));
    EXPECT_DONE(run_.run("fit cap -o maps.exr --deviation --report report.json --threads 2"));
  }

  void simulationIsACaptureWithItsTruth() {
    for (const char* name : {"capture.json", "white.exr", "white_blue.exr", "white_green.exr",
                             "mask.png", "maps.exr"}) {
      QVERIFY2(std::filesystem::exists(run_ / "cap" / name), name);
    }
    const MapsFile truth = run_.maps("cap/maps.exr");
    QCOMPARE(truth.attributes.method, std::string("ground truth"));
    QCOMPARE(truth.attributes.profileName, std::string(kDefaultProfile));
    QVERIFY(!truth.attributes.profileJson.empty());
    const std::vector<ParameterVector> skin = parametersOf(truth.maps);
    const std::vector<float> states = valuesOf(truth.maps.state);
    const std::vector<float> red = valuesOf(run_.image("cap/white.exr").channels[0]);
    const SpectrumRows rows = responseRows(monitorRig());
    for (std::size_t i = 0; i < kPixels; i += 7) {
      if (states[i] == 0.0f) EXPECT_NEAR(double{red[i]}, seen(rows, skin[i])[0], 1e-4);
    }
  }

  void fitFindsTheSkinThatWasPhotographed() {
    const MapsFile maps = run_.maps("maps.exr");
    QCOMPARE(maps.maps.width(), kChainWidth);
    QCOMPARE(maps.deviations.size(), std::size_t{kParameterCount});
    QCOMPARE(maps.residuals.size(), std::size_t{9});
    QCOMPARE(maps.attributes.rigName, std::string("monitor"));
    QCOMPARE(maps.attributes.method, std::string("refined"));
    QCOMPARE(maps.attributes.sources.size(), std::size_t{3});
    const auto truth = parametersOf(run_.maps("cap/maps.exr").maps);
    const auto found = parametersOf(maps.maps);
    const std::vector<float> states = valuesOf(maps.maps.state);
    double sum = 0.0;
    int count = 0;
    for (std::size_t i = 0; i < kPixels; i += 11) {
      if (states[i] != 0.0f) continue;
      const Spectrum error =
          usualModel().reflectance(found[i]) - usualModel().reflectance(truth[i]);
      sum += error.segment(kVisibleBand.first, kVisibleBand.count()).square().mean();
      ++count;
    }
    QVERIFY(count > 300);
    // Noise is assumed, and the least that it leaves of so light a skin is about this.
    EXPECT_AT_MOST(sum / count, 1e-4);
  }

  void reportCountsWhatWasDone() {
    const auto report = nlohmann::json::parse(run_.read("report.json"));
    QCOMPARE(report["method"].get<std::string>(), std::string("refined"));
    QCOMPARE(report["profile"].get<std::string>(), std::string(kDefaultProfile));
    QCOMPARE(report["width"].get<int>(), kChainWidth);
    QCOMPARE(report["height"].get<int>(), kChainHeight);
    const auto& pixels = report["pixels"];
    std::size_t sum = 0;
    for (const char* kind : {"masked", "invalid", "saturated", "duplicate", "solved"}) {
      sum += pixels[kind].get<std::size_t>();
    }
    QCOMPARE(pixels["total"].get<std::size_t>(), kPixels);
    QCOMPARE(sum, kPixels);
    QVERIFY(pixels["masked"].get<int>() > 0 && pixels.contains("no_convergence"));
    QVERIFY(report["node_error"]["rms"].get<double>() <= 1e-5);
    QVERIFY(report["node_error"]["worst"].get<double>() <= 1e-3);
    for (const char* stage : {"load", "prepare", "fit", "write"}) {
      QVERIFY(report["seconds"][stage].get<double>() > 0.0);
    }
    EXPECT_AT_MOST(report["residual"]["p95"].get<double>(), 1.5e-3);
    QVERIFY(report["iterations"]["mean"].get<double>() <=
            report["iterations"]["max"].get<double>());
    QVERIFY(report["nodes"].get<int>() >= 8);
    QCOMPARE(report["gamut"]["exposure"].get<double>(), 1.0);
    EXPECT_AT_MOST(report["gamut"]["outside"].get<double>(), 0.01 * kPixels);
    QVERIFY(report["threads"].get<int>() <= 2);
    QVERIFY(!report["isa"].get<std::string>().empty());
    QVERIFY(report["peak_memory_bytes"].get<double>() > 1e6);
  }

  void editFollowsTheFormulas() {
    EXPECT_DONE(
        run_.run("edit cap/maps.exr -o edited.exr --melanin 1.5 --melanin-blend 0.5 "
                 "--haemoglobin 2 --add carotene=0.001"));
    const MapsFile edited = run_.maps("edited.exr");
    const auto before = parametersOf(run_.maps("cap/maps.exr").maps);
    const auto after = parametersOf(edited.maps);
    const std::vector<float> states = valuesOf(edited.maps.state);
    const ParameterAxes& axes = usualModel().profile().axes;
    const auto expected = [&](const ParameterVector& c, int k) -> double {
      switch (k) {
        case kMelanin:
          return 1.5 * c[k];
        case kMelaninBlend:
          return 0.5 * c[k];
        case kHaemoglobinDermal:
          return c[k] * (1.0 + std::cbrt(c[k] / 0.5));
        case kHaemoglobinEpidermal:
          return c[k] * (1.0 + c[k] / 0.3);
        default:
          return c[k] + 0.001;
      }
    };
    for (std::size_t i = 0; i < kPixels; ++i) {
      for (int k = 0; k < kParameterCount; ++k) {
        const double most = axes[static_cast<std::size_t>(k)].maximum;
        const double wanted = states[i] == 0.0f ? std::min(expected(before[i], k), most) : 0.0;
        EXPECT_NEAR(after[i][k], wanted, 1e-5 * most);
      }
    }
  }

  void renderIsTheIntegral_data() {
    QTest::addColumn<QString>("options");
    QTest::addColumn<PictureRequest>("request");
    PictureRequest tungsten;
    tungsten.light = "A";
    tungsten.adaptation = ChromaticAdaptation::bradford;
    PictureRequest infrared;
    infrared.band = kNearInfraredBand;
    QTest::newRow("D65") << "" << PictureRequest();
    QTest::newRow("A") << "--light A --adapt bradford" << tungsten;
    QTest::newRow("nir") << "--band nir" << infrared;
  }

  void renderIsTheIntegral() {
    QFETCH(QString, options);
    QFETCH(PictureRequest, request);
    EXPECT_DONE(run_.run("render cap/maps.exr -o picture.exr --bit-depth float " + options));
    const Image picture = run_.image("picture.exr");
    const SpectrumRows rows = rowsOf(request);
    QCOMPARE(picture.channels.size(), static_cast<std::size_t>(rows.rows()));
    QVERIFY(picture.sourceType == SampleType::float32);
    const MapsFile maps = run_.maps("cap/maps.exr");
    const auto skin = parametersOf(maps.maps);
    const std::vector<float> states = valuesOf(maps.maps.state);
    for (std::size_t k = 0; k < picture.channels.size(); ++k) {
      const std::vector<float> values = valuesOf(picture.channels[k]);
      for (std::size_t i = 0; i < kPixels; i += 13) {
        const double wanted =
            states[i] == 0.0f ? seen(rows, skin[i])[static_cast<Eigen::Index>(k)] : 0.0;
        EXPECT_NEAR(double{values[i]}, wanted, 1e-3);
      }
    }
  }

  void renderedIntegersAreSrgb() {
    EXPECT_DONE(run_.run("render cap/maps.exr -o picture.png"));
    const Image picture = run_.image("picture.png");
    QVERIFY(picture.sourceType == SampleType::uint8);
    QCOMPARE(picture.colors.stated(), std::string("sRGB"));
    const MapsFile maps = run_.maps("cap/maps.exr");
    const auto skin = parametersOf(maps.maps);
    const std::vector<float> states = valuesOf(maps.maps.state);
    const std::vector<float> green = valuesOf(picture.channels[1]);
    const SpectrumRows rows = rowsOf({});
    for (std::size_t i = 0; i < kPixels; i += 13) {
      const double wanted = states[i] == 0.0f ? encodeSrgb(seen(rows, skin[i])[1]) : 0.0;
      EXPECT_NEAR(double{green[i]}, wanted, 0.6 / 255.0);
    }
  }

  void applyMultipliesByTheChangeOfTheModel() {
    EXPECT_DONE(run_.run("apply cap --maps maps.exr -o plain.exr"));
    EXPECT_DONE(run_.run("apply cap --maps maps.exr -o tanned.exr --melanin 2"));
    const MapsFile maps = run_.maps("maps.exr");
    const auto skin = parametersOf(maps.maps);
    const std::vector<float> states = valuesOf(maps.maps.state);
    const SpectrumRows rows = rowsOf({});
    const Image plain = run_.image("plain.exr"), tanned = run_.image("tanned.exr");
    for (std::size_t k = 0; k < 3; ++k) {
      const std::vector<float> before = valuesOf(plain.channels[k]);
      const std::vector<float> after = valuesOf(tanned.channels[k]);
      for (std::size_t i = 0; i < kPixels; i += 13) {
        double ratio = 1.0;
        if (states[i] == 0.0f) {
          ParameterVector edited = skin[i];
          edited[kMelanin] = std::min(2.0 * edited[kMelanin], 0.5);
          const auto channel = static_cast<Eigen::Index>(k);
          ratio = seen(rows, edited)[channel] / seen(rows, skin[i])[channel];
        }
        EXPECT_NEAR(double{after[i]}, ratio * double{before[i]}, 1e-3);
      }
    }
  }

  void infoTellsWhatIsInTheFiles() {
    const Outcome maps = run_.run("info maps.exr");
    EXPECT_DONE(maps);
    for (const char* part : {"kind: chromophore maps", "size: 96 × 64", "profile: skin2026",
                             "rig: monitor", "method: refined", "melanin: median 0.0"}) {
      QVERIFY2(maps.output.find(part) != std::string::npos, maps.output.c_str());
    }
    const Outcome capture = run_.run("info cap");
    EXPECT_DONE(capture);
    QVERIFY(capture.output.find("kind: capture") != std::string::npos);
    const Outcome system = run_.run("info --system");
    EXPECT_DONE(system);
    QVERIFY(system.output.find("rigs: albedo, monitor") != std::string::npos);
  }

  void threadsDoNotChangeAByte() {
    EXPECT_DONE(run_.run("fit cap -o maps1.exr --deviation --threads 1"));
    QVERIFY(run_.read("maps1.exr") == run_.read("maps.exr"));
    for (const QString threads : {"1", "2"}) {
      EXPECT_DONE(run_.run("apply cap --maps maps.exr -o a" + threads +
                           ".png --melanin 2 --threads " + threads));
    }
    QVERIFY(run_.read("a1.png") == run_.read("a2.png"));
  }

  void simulatedMapsCanBePhotographedAgain() {
    EXPECT_DONE(run_.run("simulate cap/maps.exr --rig albedo --noise 0 -o again --threads 1"));
    const Image photograph = run_.image("again/D65.exr");
    QCOMPARE(photograph.width, kChainWidth);
    QVERIFY(!std::filesystem::exists(run_ / "again/maps.exr"));
    EXPECT_DONE(run_.run("fit again -o again.exr"));
    QCOMPARE(run_.maps("again.exr").attributes.rigName, std::string("albedo"));
  }

 private:
  ProgramRun run_;
};

CUTIS_TEST(ChainTest)

}  // namespace
}  // namespace cutis::test

#include "chain_test.moc"
