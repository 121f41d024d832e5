// Maps with constants of each pixel's own, in the window as on the command line: views, the
// spectrum under the cursor and the exported albedo.

#include <QSignalSpy>
#include <QtTest>

#include "src/app/export/export.h"
#include "src/app/views/view_server.h"
#include "src/files/resources.h"
#include "tests/src/cli/program_run.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

constexpr int kPatienceMs = 120000;
constexpr int kMapsWidth = 40, kMapsHeight = 24;

// Both constants vary over the picture.
void giveConstants(MapsFile& file) {
  std::vector<float> oxygenation, thickness;
  for (int i = 0; i < kMapsWidth * kMapsHeight; ++i) {
    oxygenation.push_back(0.3f + 0.5f * static_cast<float>(i % kMapsWidth) / kMapsWidth);
    thickness.push_back(0.25f + 0.2f * static_cast<float>(i / kMapsWidth) / kMapsHeight);
  }
  file.maps.constants[kOxygenation] = planeOf(kMapsWidth, kMapsHeight, oxygenation);
  file.maps.constants[kThickness] = planeOf(kMapsWidth, kMapsHeight, thickness);
}

class FreeWindowTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    EXPECT_DONE(run_.run("simulate --patch 40x24 --profile li2024 -o patch"));
    MapsFile file = run_.maps("patch/maps.exr");
    giveConstants(file);
    EXPECT_OK(writeMaps(run_ / "free.exr", file, {}));
    document_.open(run_ / "free.exr");
    QTRY_VERIFY_WITH_TIMEOUT(document_.isOpen(), kPatienceMs);
    QVERIFY(document_.isFitted());
    QCOMPARE(document_.scene().perPixel().free.count(), 2);
  }
  void cleanupTestCase() { jobs_.stopAll(); }

  void viewsAreWhatRenderWrites_data() {
    QTest::addColumn<int>("view");
    QTest::addColumn<QString>("options");
    QTest::newRow("skin") << int(ViewKind::skin) << "--light A";
    QTest::newRow("ultraviolet") << int(ViewKind::ultraviolet) << "--band uv";
    QTest::newRow("near infrared") << int(ViewKind::nearInfrared) << "--band nir";
  }
  void viewsAreWhatRenderWrites() {
    QFETCH(int, view);
    QFETCH(QString, options);
    EXPECT_DONE(run_.run("render free.exr -o seen.exr --bit-depth float " + options));
    server_.setPicture({"A", "cie1931", ChromaticAdaptation::none, std::nullopt});
    std::shared_ptr<const ViewPart> part;
    const auto watch =
        server_.watch(ViewPriority::detail, [&](const auto& served) { part = served; });
    watch->want({static_cast<ViewKind>(view), {0, 0, kMapsWidth, kMapsHeight}, 1});
    QTRY_VERIFY_WITH_TIMEOUT(part != nullptr, kPatienceMs);
    const Image seen = run_.image("seen.exr");
    QCOMPARE(part->pixels.channels.size(), seen.channels.size());
    for (std::size_t c = 0; c < seen.channels.size(); ++c)
      QVERIFY(part->pixels.channels[c] == valuesOf(seen.channels[c]));
  }

  // The same skin on the command line: the profile with the constants of the pixel.
  void theSpectrumIsThatOfTheCommandLine() {
    const auto spectra = document_.spectraAt(20, 12);
    QVERIFY(spectra.has_value());
    std::string text(*resource("profiles/li2024.json"));
    const auto profile = parseProfile(text, "li2024");
    EXPECT_OK(profile);
    EXPECT_NEAR(spectra->constants.oxygenation, 0.55, 1e-6);
    EXPECT_NEAR(spectra->constants.thicknessMm, 0.35, 1e-6);
    const SkinModel expected(withConstants(profile.value(), spectra->constants));
    const Spectrum there = expected.reflectance(spectra->originalParameters);
    EXPECT_AT_MOST((spectra->original - there).abs().maxCoeff(), 1e-9);
    const SkinModel without(profile.value());
    QVERIFY((there - without.reflectance(spectra->originalParameters)).abs().maxCoeff() > 1e-3);
  }

  void theExportIsWhatApplyWrites() {
    EXPECT_DONE(run_.run("apply patch --maps free.exr -o applied.exr --melanin 1.5"));
    const auto store = std::make_shared<TileStore>(std::size_t{1} << 28);
    auto source = openSource(run_ / "patch", {}, *document_.scene().model, store, {});
    EXPECT_OK(source);
    EditedAlbedo albedo = {document_.scene(),
                           std::make_shared<const Source>(std::move(source).value())};
    albedo.skin.edits.emplace_back().parameters[kMelanin].scale = 1.5;
    EXPECT_OK(exportTo({run_ / "exported.exr"}, albedo, engine_, store, {}));
    const Image applied = run_.image("applied.exr"), exported = run_.image("exported.exr");
    for (std::size_t c = 0; c < 3; ++c)
      QVERIFY(valuesOf(applied.channels[c]) == valuesOf(exported.channels[c]));
  }

 private:
  ProgramRun run_;
  Engine engine_{std::filesystem::path()};
  JobRunner jobs_;
  Document document_{engine_, jobs_};
  ViewServer server_{document_, engine_, jobs_};
};

CUTIS_TEST(FreeWindowTest)

}  // namespace
}  // namespace cutis::test

#include "free_window_test.moc"
