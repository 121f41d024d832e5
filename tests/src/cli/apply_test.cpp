// apply to albedo textures: what is not edited is not touched.

#include <cmath>

#include "src/color/icc_profile.h"
#include "tests/src/cli/program_run.h"
#include "tests/support/expect.h"
#include "tests/support/icc_bytes.h"
#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

constexpr int kWidth = 40;
constexpr int kHeight = 24;

class ApplyTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void initTestCase() {
    run_.writeImage("skin.png", skinTexture(kWidth, kHeight, {"R", "G", "B"}), SampleType::uint8);
    ImageContent tiff = skinTexture(kWidth, kHeight, {"R", "G", "B", "A"});
    tiff.colorSpace = builtInColorSpace("sRGB");
    run_.writeImage("skin.tif", tiff, SampleType::uint16);
    ImageContent exr = skinTexture(kWidth, kHeight, {"R", "G", "B", "A", "pores"});
    exr.colorSpace = builtInColorSpace("ACEScg");
    run_.writeImage("skin.exr", exr, SampleType::half);
    // Right half.
    std::vector<float> mask;
    for (int i = 0; i < kWidth * kHeight; ++i)
      mask.push_back(i % kWidth < kWidth / 2 ? 0.0f : 1.0f);
    ImageContent maskImage;
    maskImage.channelNames = {"Y"};
    maskImage.channels = {planeOf(kWidth, kHeight, mask)};
    run_.writeImage("mask.png", maskImage, SampleType::uint8);
    EXPECT_DONE(run_.run("fit skin.exr -o maps.exr --exposure 0.7"));
  }

  void uneditedPixelsAreTheSources_data() {
    QTest::addColumn<QString>("extension");
    for (const char* extension : {"png", "tif", "exr"})
      QTest::newRow(extension) << extension;
  }

  void uneditedPixelsAreTheSources() {
    QFETCH(QString, extension);
    EXPECT_DONE(run_.run("apply skin." + extension + " -o same." + extension + " --quiet"));
    const Image source = run_.image("skin." + extension.toStdString());
    const Image same = run_.image("same." + extension.toStdString());
    QCOMPARE(same.channelNames, source.channelNames);
    QVERIFY(same.sourceType == source.sourceType);
    QCOMPARE(decideColors(same.colors, {}, "same").value().followed.space.name,
             decideColors(source.colors, {}, "source").value().followed.space.name);
    for (std::size_t k = 0; k < source.channels.size(); ++k) {
      QVERIFY2(valuesOf(same.channels[k]) == valuesOf(source.channels[k]),
               source.channelNames[k].c_str());
    }
  }

  // Which layer is meant is asked for where nothing tells, and said in reports.
  void layersAreNotGuessed() {
    ImageContent content = skinTexture(kWidth, kHeight, {"R", "G", "B", "A", "pores", "Z"});
    content.channelNames = {"albedo.R", "albedo.G", "albedo.B", "glow.R", "glow.G", "glow.B"};
    run_.writeImage("layers.exr", content, SampleType::half);
    const Outcome open = run_.run("fit layers.exr -o layers_maps.exr");
    QCOMPARE(open.status, 3);
    QCOMPARE(open.errors, std::string("cutis-cli: --layer: 'layers.exr' has no plain channels R, G "
                                      "and B, but 'albedo' and 'glow' have colours; choose one of "
                                      "them\n"));
    const Outcome info = run_.run("info layers.exr");
    QCOMPARE(info.status, 0);
    QVERIFY(info.output.find("read layer: none of plain channels; --layer chooses\n") !=
            std::string::npos);
    const Outcome chosen =
        run_.run("fit layers.exr -o layers_maps.exr --layer albedo --report layers.json");
    QVERIFY2(chosen.status == 0, chosen.errors.c_str());
    QVERIFY(run_.read("layers.json").find("\"layer\": \"albedo\"") != std::string::npos);
  }

  // Through curves and a matrix that no built-in space has.
  void profilesOfTheSourceAreKeptToTheBit() {
    const std::string profile =
        matrixProfile(2, kRec2020.chromaticities,
                      sampledTag(300, [](double v) { return std::pow(v, 1.9); }), "sRGB");
    const auto read = readIccProfile(profile, "test");
    EXPECT_OK(read);
    ImageContent content = skinTexture(kWidth, kHeight, {"R", "G", "B"});
    content.colorSpace = read.value().space;
    for (const char* extension : {"png", "tif"}) {
      const std::string source = std::string("icc.") + extension;
      const std::string same = std::string("icc_same.") + extension;
      run_.writeImage(source, content, SampleType::uint16);
      const Outcome outcome = run_.run(QString::fromStdString("apply " + source + " -o " + same));
      QCOMPARE(outcome.status, 0);
      QVERIFY2(outcome.errors.find("its colours are read by its ICC profile 'sRGB'") !=
                   std::string::npos,
               outcome.errors.c_str());
      const Image before = run_.image(source), after = run_.image(same);
      for (std::size_t k = 0; k < 3; ++k)
        QVERIFY(valuesOf(before.channels[k]) == valuesOf(after.channels[k]));
      const ColorStatement& statement = after.colors.statements.front();
      QVERIFY(statement.space.profile && *statement.space.profile == profile);
    }
    const Outcome info = run_.run("info icc.png");
    QVERIFY(info.output.find("statement: its ICC profile 'sRGB': the space of the ICC profile "
                             "'sRGB'") != std::string::npos);
  }

  void maskedEditLeavesTheRestAlone() {
    EXPECT_DONE(
        run_.run("apply skin.exr --maps maps.exr -o tanned.exr --melanin 2 "
                 "--mask mask.png"));
    const Image source = run_.image("skin.exr"), tanned = run_.image("tanned.exr");
    QCOMPARE(tanned.colors.stated(), std::string("ACEScg"));
    for (std::size_t k = 0; k < source.channels.size(); ++k) {
      const std::vector<float> before = valuesOf(source.channels[k]);
      const std::vector<float> after = valuesOf(tanned.channels[k]);
      const bool isColor = k < 3;
      for (std::size_t i = 0; i < before.size(); ++i) {
        const bool edited = isColor && i % kWidth >= kWidth / 2;
        if (edited) {
          QVERIFY2(after[i] < before[i], source.channelNames[k].c_str());
        } else {
          QVERIFY2(after[i] == before[i], source.channelNames[k].c_str());
        }
      }
    }
  }

  // The preset comes first, the options' edit after it, the mask bounds both.
  void presetIsEditedBeforeTheOptions() {
    run_.write("tan.json", R"({"cutis_edits": 1, "edits": [{"name": "Tan",
        "melanin": {"mode": "scale", "value": 3}, "carotene": {"mode": "set", "value": 0.001}}]})");
    EXPECT_DONE(
        run_.run("apply skin.exr --maps maps.exr -o a.exr --mask mask.png --melanin 3 "
                 "--set carotene=0.001"));
    EXPECT_DONE(
        run_.run("apply skin.exr --maps maps.exr -o b.exr --mask mask.png --preset tan.json"));
    QCOMPARE(run_.read("b.exr"), run_.read("a.exr"));
    EXPECT_DONE(run_.run("edit maps.exr -o twice.exr --preset tan.json --add melanin=0.001"));
    EXPECT_DONE(run_.run("edit maps.exr -o once.exr --preset tan.json"));
    const std::vector<float> once = valuesOf(run_.maps("once.exr").maps.values[kMelanin]);
    const std::vector<float> twice = valuesOf(run_.maps("twice.exr").maps.values[kMelanin]);
    EXPECT_NEAR(twice.front() - once.front(), 0.001, 1e-6);
  }

  void presetOfALaterVersionIsRefused() {
    run_.write("later.json", R"({"cutis_edits": 2, "edits": []})");
    const Outcome outcome = run_.run("edit maps.exr -o out.exr --preset later.json");
    QCOMPARE(outcome.status, 3);
    QVERIFY2(outcome.errors.find("later.json: cutis_edits is 2") != std::string::npos,
             outcome.errors.c_str());
  }

  void pureIsTheModelInTheSourcesExposure() {
    EXPECT_DONE(run_.run("apply skin.exr --maps maps.exr -o pure.exr --pure"));
    const std::vector<float> before = valuesOf(run_.image("skin.exr").channels[1]);
    const std::vector<float> model = valuesOf(run_.image("pure.exr").channels[1]);
    double ratio = 0.0;
    for (std::size_t i = 0; i < before.size(); ++i)
      ratio += double{model[i]} / double{before[i]};
    EXPECT_NEAR(ratio / static_cast<double>(before.size()), 1.0, 0.1);
  }

  void anotherSpaceConvertsAllPixels() {
    const Outcome outcome = run_.run("apply skin.exr --maps maps.exr -o out.png");
    QCOMPARE(outcome.status, 0);
    QVERIFY2(outcome.errors.find("cutis-cli: note: ") == 0, outcome.errors.c_str());
    const Image written = run_.image("out.png");
    QCOMPARE(written.colors.stated(), std::string("sRGB"));
    // Halves hold more than 8 bits.
    QVERIFY(written.sourceType == SampleType::uint16);
  }

  void mapsOfAnotherPictureAreNoted() {
    const Outcome outcome = run_.run("apply skin.png --maps maps.exr -o other.png");
    QCOMPARE(outcome.status, 0);
    QVERIFY2(outcome.errors.find("made from another picture") != std::string::npos,
             outcome.errors.c_str());
  }

  void exposureIsChosenAndTold() {
    const Outcome outcome = run_.run("fit skin.exr -o auto.exr --exposure auto");
    QCOMPARE(outcome.status, 0);
    QVERIFY2(outcome.errors.find("note: skin.exr: exposure ") != std::string::npos,
             outcome.errors.c_str());
    const double chosen = run_.maps("auto.exr").attributes.exposure;
    QVERIFY(chosen >= 0.125 && chosen <= 2.0);
    EXPECT_DONE(run_.run("fit skin.exr -o hand.exr --quiet --exposure " +
                         QString::number(chosen, 'g', 17)));
    const MapsFile automatic = run_.maps("auto.exr"), byHand = run_.maps("hand.exr");
    for (const Parameter parameter : kParameters) {
      QVERIFY(valuesOf(automatic.maps.values[parameter]) ==
              valuesOf(byHand.maps.values[parameter]));
    }
  }

 private:
  ProgramRun run_;
};

CUTIS_TEST(ApplyTest)

}  // namespace
}  // namespace cutis::test

#include "apply_test.moc"
