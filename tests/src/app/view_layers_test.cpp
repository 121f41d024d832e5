// What a fit says of its values, photographs and bands as views, on the embedded sample.

#include <cmath>

#include <QSignalSpy>
#include <QtTest>

#include "core/fit/fit_run.h"
#include "src/app/document/document.h"
#include "src/app/open/photograph_part.h"
#include "src/app/views/view_server.h"
#include "tests/support/expect.h"
#include "tests/support/rendered_view.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace view_layers {

constexpr int kPatienceMs = 120000;
constexpr Rect kPart = {300, 300, 401, 381};

class ViewLayersTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    document_.openSample();
    QTRY_VERIFY_WITH_TIMEOUT(document_.isFitted(), kPatienceMs);
    QTRY_VERIFY(jobs_.isIdle());
  }
  void cleanupTestCase() { jobs_.stopAll(); }

  // The same numbers as those that a fit writes into files.
  void deviationsAndResidualsAreThoseOfTheFit() {
    const auto tools = document_.scene().evidence->tools(engine_, {});
    EXPECT_OK(tools);
    const Measurements& measurements = document_.scene().source->measurements;
    FitOptions options;
    options.deviations = options.residuals = true;
    const FitPlanes planes(measurements, options, nullptr);
    EXPECT_OK(runFit(measurements, *tools.value()->solver, planes, {}));
    const ViewPart residual = rendered(ViewKind::residual);
    for (const Parameter parameter : kParameters) {
      const auto view = static_cast<ViewKind>(static_cast<int>(ViewKind::melaninDeviation) +
                                              static_cast<int>(parameter));
      QVERIFY(deviationOf(view) == parameter);
      const ViewPart part = rendered(view);
      QCOMPARE(part.pixels.channels.size(), std::size_t{1});
      const auto k = static_cast<std::size_t>(parameter);
      for (std::size_t i = 0; i < part.pixels.present.size(); ++i) {
        if (part.pixels.present[i])
          EXPECT_NEAR(double{part.pixels.channels[0][i]}, valueOf(planes.deviations[k], i), 1e-6);
      }
    }
    const NoiseModel noise = measurements.rig.noise;
    for (std::size_t i = 0; i < residual.pixels.present.size(); ++i) {
      if (!residual.pixels.present[i]) continue;
      double sum = 0.0;
      for (std::size_t k = 0; k < planes.residuals.size(); ++k)
        sum += std::pow(valueOf(planes.residuals[k], i), 2) /
               noise.variance(valueOf(measurements.channels[k], i));
      const double expected = std::sqrt(sum / static_cast<double>(planes.residuals.size()));
      EXPECT_NEAR(double{residual.pixels.channels[0][i]}, expected, 1e-3 * (1.0 + expected));
    }
  }

  void editsDoNotChangeWhatWasMeasured() {
    const ViewPart before = rendered(ViewKind::residual);
    document_.apply({"melanin", {}, [](DocumentState& state) {
                       state.edits.emplace_back().parameters[kMelanin].scale = 2.0;
                     }});
    const ViewPart after = rendered(ViewKind::residual);
    document_.undo();
    QVERIFY(before.pixels.channels == after.pixels.channels);
  }

  void eachPhotographIsAView() {
    const Scene& scene = document_.scene();
    const auto lights = static_cast<int>(scene.source->measurements.rig.lights.size());
    QVERIFY(lights > 1);
    for (int i = 0; i < lights; ++i) {
      QVERIFY(canShow(scene, lightView(i)));
      const auto expected = photographPart(*scene.source, kPart, 2, i);
      QVERIFY(rendered(lightView(i)).pixels.channels == expected.value().channels);
    }
    QVERIFY(!canShow(scene, lightView(lights)));
    QVERIFY(rendered(lightView(0)).pixels.channels ==
            rendered(ViewKind::photograph).pixels.channels);
  }

  // The mean over a band lies between the least and the most of its wavelengths.
  void aBandIsOneWavelength() {
    const auto at = [&](double wavelength) {
      ViewRequest request = {ViewKind::band, kPart, 2};
      request.wavelengthNm = wavelength;
      return test::renderedView(document_.scene(), engine_, {}, request).value().pixels;
    };
    const PictureBuffer green = at(550.0);
    for (int y = 0; y < green.height; y += 13) {
      for (int x = 0; x < green.width; x += 13) {
        const auto i = static_cast<std::size_t>(y * green.width + x);
        if (!green.present[i]) continue;
        const auto spectra = document_.spectraAt(kPart.x0 + 2 * x, kPart.y0 + 2 * y);
        EXPECT_NEAR(double{green.channels[0][i]}, spectra->original[125], 1e-4);
      }
    }
    QVERIFY(at(700.0).channels != green.channels);
  }

  void whatTheFitDidNotFindIsNotOffered() {
    const Scene& scene = document_.scene();
    QVERIFY(!canShow(scene, ViewKind::shading));
    QVERIFY(!canShow(scene, ViewKind::oxygenation));
    QVERIFY(!canShow(scene, ViewKind::thickness));
    Scene mapsAlone = scene;
    mapsAlone.source = nullptr;
    mapsAlone.evidence = nullptr;
    QVERIFY(!canShow(mapsAlone, ViewKind::residual));
    QVERIFY(!canShow(mapsAlone, lightView(0)));
    QVERIFY(canShow(mapsAlone, ViewKind::band));
  }

  // What nobody watches is not made, and one view makes no other.
  void onlyWhatIsWatchedIsComputed() {
    int served = 0;
    QSignalSpy idle(&jobs_, &JobRunner::idle);
    const auto hidden = server_.watch(ViewPriority::thumbnail, [&](const auto&) { ++served; });
    hidden->setSeen(false);
    hidden->want({ViewKind::melaninDeviation, kPart, 1});
    QTest::qWait(50);
    QCOMPARE(served, 0);
    QCOMPARE(idle.count(), 0);
    hidden->setSeen(true);
    QTRY_COMPARE(served, 1);
    QTest::qWait(50);
    QCOMPARE(served, 1);
  }

 private:
  ViewPart rendered(ViewKind view) {
    return test::renderedView(document_.scene(), engine_, {}, {view, kPart, 2}).value();
  }

  // At sample i of kPart at a step of 2.
  static double valueOf(const Plane& plane, std::size_t i) {
    const int columns = (kPart.width() + 1) / 2;
    const int x = kPart.x0 + 2 * (static_cast<int>(i) % columns);
    const int y = kPart.y0 + 2 * (static_cast<int>(i) / columns);
    float value = 0.0f;
    static_cast<void>(plane.load({x, y, x + 1, y + 1}, {&value, 1}));
    return double{value};
  }

  Engine engine_{std::filesystem::path()};
  JobRunner jobs_;
  Document document_{engine_, jobs_};
  ViewServer server_{document_, engine_, jobs_};
};

CUTIS_TEST(ViewLayersTest)

}  // namespace view_layers
}  // namespace cutis

#include "view_layers_test.moc"
