// Changing how a document is fitted, on the embedded sample and a texture made of it.

#include <QSignalSpy>
#include <QtTest>

#include "core/skin/profile/profile_signature.h"
#include "src/app/document/document.h"
#include "src/app/export/export.h"
#include "src/files/resources.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr int kFitPatienceMs = 120000;

const FitChoice kRefined = {kDefaultProfile, FitMethod::refined, false};
const FitChoice kPaper = {kPaperProfile, FitMethod::refined, false};
const FitChoice kNetwork = {kDefaultProfile, FitMethod::network, false};
const FitChoice kThreeStage = {kDefaultProfile, FitMethod::threeStage, false};

std::vector<float> valuesOf(const ChromophoreMaps& maps) {
  std::vector<float> all;
  const Rect whole = maps.state.bounds();
  std::vector<float> plane(whole.pixelCount());
  for (const Plane& map : maps.values) {
    if (map.load(whole, plane).failed()) return {};
    all.insert(all.end(), plane.begin(), plane.end());
  }
  return all;
}

Command moreMelanin(double factor) {
  return {"melanin",
          {},
          [factor](DocumentState& state) {
            state.edits.emplace_back();
            state.edits.front().parameters[kMelanin].scale = factor;
          },
          false};
}

class DocumentFitTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    document_.openSample();
    waitUntilFitted();
    fitted_ = valuesOf(document_.scene().maps);
    QVERIFY(!fitted_.empty());
    // Another skin, that no network knows.
    std::string text(*resource("profiles/li2024.json"));
    const std::string thickness = "\"thickness_mm\": 0.32";
    QVERIFY(text.find(thickness) != std::string::npos);
    text.replace(text.find(thickness), thickness.size(), "\"thickness_mm\": 0.31");
    foreign_ = folder_.write("foreign.json", text).string();
  }
  void cleanupTestCase() { jobs_.stopAll(); }

  void init() {
    while (document_.history().canUndo())
      document_.undo();
    document_.fitWith(kRefined);
    waitUntilFitted();
  }

  void theProfileChangesTheMapsAndKeepsTheEdits() {
    document_.apply(moreMelanin(1.5));
    QSignalSpy opened(&document_, &Document::opened),
        replaced(&document_, &Document::sceneReplaced);
    QSignalSpy chosen(&document_, &Document::fitChoiceChanged);
    document_.fitWith(kPaper);
    // The maps of before are shown until there is a first impression of the new ones.
    QVERIFY(!document_.isFitted());
    QVERIFY(valuesOf(document_.scene().maps) == fitted_);
    waitUntilFitted();
    QCOMPARE(opened.count(), 0);
    QCOMPARE(replaced.count(), 1);
    QCOMPARE(chosen.count(), 1);
    QVERIFY(document_.fitChoice() == kPaper);
    QCOMPARE(document_.scene().model->profile().name, std::string(kPaperProfile));
    QVERIFY(valuesOf(document_.scene().maps) != fitted_);
    QCOMPARE(document_.scene().edits.front().parameters[kMelanin].scale, 1.5);
    QVERIFY(document_.history().canUndo());
  }

  void changingBackGivesTheSameBits() {
    document_.fitWith(kPaper);
    waitUntilFitted();
    document_.fitWith(kRefined);
    waitUntilFitted();
    QVERIFY(valuesOf(document_.scene().maps) == fitted_);
  }

  // As opened with that profile: maps, and what the photographs look like.
  void changingIsAsOpeningWithIt() {
    document_.fitWith(kPaper);
    waitUntilFitted();
    Document other(engine_, jobs_);
    other.setUsualFit(kPaper);
    other.openSample();
    QTRY_VERIFY_WITH_TIMEOUT(other.isOpen() && other.isFitted(), kFitPatienceMs);
    QVERIFY(other.fitChoice() == kPaper);
    QVERIFY(valuesOf(other.scene().maps) == valuesOf(document_.scene().maps));
    QVERIFY(other.scene().source->toRec709 == document_.scene().source->toRec709);
  }

  void spectraAreOfTheProfile() {
    document_.fitWith(kPaper);
    waitUntilFitted();
    const auto spectra = document_.spectraAt(500, 500);
    QVERIFY(spectra.has_value());
    const Spectrum expected = test::li2024().reflectance(spectra->originalParameters);
    QVERIFY((spectra->original == expected).all());
  }

  void everyMethodFits_data() {
    QTest::addColumn<int>("method");
    QTest::newRow("network") << int(FitMethod::network);
    QTest::newRow("three-stage") << int(FitMethod::threeStage);
    QTest::newRow("full search") << int(FitMethod::fullSearch);
  }
  void everyMethodFits() {
    QFETCH(int, method);
    const FitChoice choice = {kDefaultProfile, static_cast<FitMethod>(method), false};
    document_.fitWith(choice);
    waitUntilFitted();
    QVERIFY(document_.fitChoice() == choice);
    QVERIFY(valuesOf(document_.scene().maps) != fitted_);
  }

  void aChangeDuringAFitEndsWithTheLast() {
    document_.fitWith(kNetwork);
    waitUntilFitted();
    const auto expected = valuesOf(document_.scene().maps);
    document_.fitWith(kRefined);
    waitUntilFitted();
    for (const FitChoice& choice : {kPaper, kThreeStage, kPaper, kNetwork}) {
      document_.fitWith(choice);
      QTest::qWait(20);
    }
    waitUntilFitted();
    QVERIFY(document_.fitChoice() == kNetwork);
    QVERIFY(valuesOf(document_.scene().maps) == expected);
  }

  // Back to what is complete already: nothing is fitted again.
  void theLastCompleteFitComesBackAtOnce() {
    QSignalSpy fitted(&document_, &Document::fitted);
    document_.fitWith(kPaper);
    QTest::qWait(50);
    document_.fitWith(kRefined);
    QVERIFY(document_.isFitted());
    QVERIFY(valuesOf(document_.scene().maps) == fitted_);
    QTRY_VERIFY_WITH_TIMEOUT(jobs_.isIdle(), kFitPatienceMs);
    QCOMPARE(fitted.count(), 0);
  }

  void cancellingBringsBackTheLastCompleteFit() {
    QSignalSpy started(&jobs_, &JobRunner::started), replaced(&document_, &Document::sceneReplaced);
    document_.fitWith(kPaper);
    QTRY_COMPARE_WITH_TIMEOUT(replaced.count(), 1, kFitPatienceMs);
    QVERIFY(valuesOf(document_.scene().maps) != fitted_);
    jobs_.cancel(started[0][0].value<JobId>());
    QVERIFY(document_.isFitted());
    QVERIFY(document_.fitChoice() == kRefined);
    QVERIFY(valuesOf(document_.scene().maps) == fitted_);
    QCOMPARE(document_.scene().model->profile().name, std::string(kDefaultProfile));
  }

  void whatCannotBeIsToldAndChangesNothing_data() {
    QTest::addColumn<QString>("profile");
    QTest::addColumn<QString>("sentence");
    QTest::newRow("missing") << "none.json"
                             << "none.json: there is no such file";
    QTest::newRow("unknown") << "skin2027"
                             << "did you mean 'skin2026'";
    QTest::newRow("broken") << pathOf("broken.json", "{\"cutis_profile\": 1") << "broken.json:";
    QTest::newRow("no profile") << pathOf("rig.json", "{\"cutis_rig\": 1}") << "rig.json";
  }
  void whatCannotBeIsToldAndChangesNothing() {
    QFETCH(QString, profile);
    QFETCH(QString, sentence);
    QSignalSpy failed(&document_, &Document::failed);
    document_.fitWith({profile.toStdString(), FitMethod::refined, false});
    QTRY_COMPARE_WITH_TIMEOUT(failed.count(), 1, kFitPatienceMs);
    QVERIFY2(failed[0][0].toString().contains(sentence), qPrintable(failed[0][0].toString()));
    QVERIFY(document_.isFitted());
    QVERIFY(document_.fitChoice() == kRefined);
    QVERIFY(valuesOf(document_.scene().maps) == fitted_);
  }

  void shadingIsForRefinedAlone() {
    QSignalSpy failed(&document_, &Document::failed);
    document_.fitWith({kDefaultProfile, FitMethod::network, true});
    QCOMPARE(failed.count(), 1);
    QVERIFY(document_.isFitted());
    document_.fitWith({kDefaultProfile, FitMethod::refined, true});
    waitUntilFitted();
    QVERIFY(document_.fitChoice().shading);
    QVERIFY(valuesOf(document_.scene().maps) != fitted_);
  }

  void withoutANetworkTheProfileIsTakenAndTheMethodStays() {
    QSignalSpy missing(&document_, &Document::networkMissing);
    document_.fitWith({foreign_, FitMethod::network, false});
    QTRY_COMPARE_WITH_TIMEOUT(missing.count(), 1, kFitPatienceMs);
    waitUntilFitted();
    QVERIFY(document_.fitChoice() == (FitChoice{foreign_, FitMethod::refined, false}));
    document_.fitWith({foreign_, FitMethod::threeStage, false});
    waitUntilFitted();
    document_.fitWith({foreign_, FitMethod::network, false});
    QTRY_COMPARE_WITH_TIMEOUT(missing.count(), 2, kFitPatienceMs);
    QVERIFY(document_.isFitted());
    QCOMPARE(document_.fitChoice().method, FitMethod::threeStage);
  }

  void aNetworkThatIsAddedIsUsed() {
    const auto model = engine_.model(foreign_, {});
    EXPECT_OK(model);
    const Rig rig = document_.scene().source->measurements.rig;
    auto known = engine_.network(document_.scene().model->profile(), rig);
    EXPECT_OK(known);
    QVERIFY(known.value() != nullptr);
    ChromophoreNetwork network = *known.value();
    network.profile = signatureOf(model.value()->profile());
    document_.useNetwork(std::make_shared<const ChromophoreNetwork>(network), foreign_);
    waitUntilFitted();
    QVERIFY(document_.fitChoice() == (FitChoice{foreign_, FitMethod::network, false}));
    const auto kept = engine_.network(model.value()->profile(), rig);
    EXPECT_OK(kept);
    QVERIFY(kept.value() != nullptr);
  }

  // A texture is fitted at another exposure for another profile, as if it were opened with that,
  // and its file is not read again for it.
  void aTextureFollowsTheProfile() {
    const std::string texture = writeTexture(1.0);
    Document changed(engine_, jobs_), opened(engine_, jobs_);
    opened.setUsualFit(kPaper);
    for (Document* document : {&changed, &opened}) {
      document->open(texture);
      QTRY_VERIFY_WITH_TIMEOUT(document->isOpen() && document->isFitted(), kFitPatienceMs);
    }
    QVERIFY(std::filesystem::remove(texture));
    changed.fitWith(kPaper);
    QTRY_VERIFY_WITH_TIMEOUT(changed.isFitted(), kFitPatienceMs);
    QCOMPARE(exposureOf(changed), exposureOf(opened));
    QVERIFY(valuesOf(changed.scene().maps) == valuesOf(opened.scene().maps));

    QSignalSpy failed(&changed, &Document::failed);
    changed.fitWith({kPaperProfile, FitMethod::refined, true});
    QVERIFY(failed.takeLast()[0].toString().contains("texture"));
  }

  void whatThereIsToSayOfAFitIsSaid() {
    Document texture(engine_, jobs_);
    texture.setUsualFit({"skin2026", FitMethod::refined, false});
    QSignalSpy said(&texture, &Document::noticed);
    texture.open(writeTexture(0.1));
    QTRY_VERIFY_WITH_TIMEOUT(texture.isOpen() && texture.isFitted(), kFitPatienceMs);
    QTRY_VERIFY(said.count() > 0);
    const QString sentence = said[0][0].toString();
    QVERIFY2(sentence.startsWith("texture.png: exposure "), qPrintable(sentence));
    QVERIFY(!sentence.contains("--"));
  }

 private:
  void waitUntilFitted() {
    QTRY_VERIFY_WITH_TIMEOUT(document_.isOpen() && document_.isFitted(), kFitPatienceMs);
  }
  QString pathOf(const std::string& name, std::string_view bytes) {
    return QString::fromStdString(folder_.write(name, bytes).string());
  }
  static double exposureOf(const Document& document) {
    return document.scene().source->measurements.exposure;
  }
  std::string writeTexture(double melanin) {
    Scene scene = document_.scene();
    scene.edits.emplace_back();
    scene.edits.front().parameters[kMelanin].scale = melanin;
    const auto path = folder_ / "texture.png";
    const auto store = std::make_shared<TileStore>(std::size_t{1} << 28);
    const Status written = exportTo({path}, EditedAlbedo{scene, scene.source}, engine_, store, {});
    return written ? path.string() : std::string();
  }

  test::ScratchFolder folder_;
  Engine engine_{std::filesystem::path()};
  JobRunner jobs_;
  Document document_{engine_, jobs_};
  std::vector<float> fitted_;
  std::string foreign_;
};

CUTIS_TEST(DocumentFitTest)

}  // namespace
}  // namespace cutis

#include "document_fit_test.moc"
