#include "src/color/color_space.h"

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <thread>
#include <vector>

#include <QFile>
#include <QTemporaryDir>
#include <QtTest>

#include "core/spectra/colorimetry.h"
#include "core/spectra/rgb_primaries.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using Rgb = std::array<float, 3>;

Rgb converted(const Result<ColorConverter>& converter, Rgb rgb) {
  if (!converter || !converter.value()(rgb)) return {NAN, NAN, NAN};
  return rgb;
}
Rgb toLinear(const std::string& name, Rgb rgb) {
  return converted(toLinearRec709(name, "test"), rgb);
}
Rgb fromLinear(const std::string& name, Rgb rgb) {
  return converted(fromLinearRec709(name, "test"), rgb);
}

// The names that need no configuration.
std::vector<std::string> builtIn() {
  qunsetenv("OCIO");
  return colorSpaceNames();
}

// Those whose numbers from 0 to 1 are light from 0 to 1.
std::vector<std::string> ofUnitLight() {
  std::vector<std::string> names = builtIn();
  std::erase_if(names, [](const std::string& name) { return name.starts_with("Rec.2100"); });
  return names;
}

const char kStudioConfig[] = R"(ocio_profile_version: 2
roles:
  default: raw
  aces_interchange: ACES2065-1
  scene_linear: studio
file_rules:
  - !<Rule> {name: Default, colorspace: default}
displays:
  screen:
    - !<View> {name: Raw, colorspace: raw}
colorspaces:
  - !<ColorSpace> {name: raw, isdata: true}
  - !<ColorSpace> {name: ACES2065-1}
  - !<ColorSpace>
    name: studio
    aliases: [our_space]
    to_scene_reference: !<MatrixTransform> {matrix: [2,0,0,0, 0,2,0,0, 0,0,2,0, 0,0,0,1]}
  - !<ColorSpace>
    name: broken
    to_scene_reference: !<FileTransform> {src: missing.cube}
)";

const char kOldConfig[] = R"(ocio_profile_version: 1
roles:
  default: lin_rec709
displays:
  screen:
    - !<View> {name: Raw, colorspace: lin_rec709}
colorspaces:
  - !<ColorSpace> {name: lin_rec709}
  - !<ColorSpace>
    name: halved
    to_reference: !<MatrixTransform> {matrix: [2,0,0,0, 0,2,0,0, 0,0,2,0, 0,0,0,1]}
)";

class ColorSpaceTest : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;

  void useConfig(const QByteArray& text) {
    static int serial = 0;
    const QString path = folder_.filePath(QString("config%1.ocio").arg(++serial));
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    file.write(text);
    qputenv("OCIO", path.toUtf8());
  }

  void expectMatrix(const std::string& name, const std::array<double, 9>& published,
                    double tolerance) {
    for (std::size_t column = 0; column < 3; ++column) {
      Rgb unit = {};
      unit[column] = 1.0f;
      const Rgb out = toLinear(name, unit);
      for (std::size_t row = 0; row < 3; ++row) {
        EXPECT_NEAR(out[row], published[3 * row + column], tolerance);
      }
    }
  }

 private slots:
  void init() { qunsetenv("OCIO"); }
  void cleanup() { qunsetenv("OCIO"); }

  // IEC 61966-2-1, and the curve of core/spectra.
  void sRgbIsTheStandardsCurve() {
    EXPECT_NEAR(toLinear("sRGB", {0.5f, 0, 0})[0], 0.214041140, 1e-7);
    EXPECT_NEAR(fromLinear("sRGB", {0.18f, 0, 0})[0], 0.461356129, 1e-7);
    for (double value = -0.5; value <= 2.0; value += 1.0 / 512.0) {
      const auto v = static_cast<float>(value);
      EXPECT_NEAR(toLinear("sRGB", {v, 0, 0})[0], decodeSrgb(v), 1e-6 * std::abs(decodeSrgb(v)));
      EXPECT_NEAR(fromLinear("sRGB", {0, v, 0})[1], encodeSrgb(v), 1e-6 * std::abs(encodeSrgb(v)));
    }
  }

  // S-2014-004 with Bradford adaptation, as in the ACES configurations of OpenColorIO.
  void acesMatricesArePublished() {
    expectMatrix("ACEScg",
                 {1.7050510, -0.6217921, -0.0832589, -0.1302564, 1.1408047, -0.0105483, -0.0240034,
                  -0.1289690, 1.1529724},
                 1e-5);
    expectMatrix("ACES2065-1",
                 {2.5216861, -1.1341310, -0.3875552, -0.2764800, 1.3727190, -0.0962392, -0.0153780,
                  -0.1529754, 1.1683534},
                 1e-5);
  }

  // ITU-R BT.2087 annex 2, inverted; SMPTE EG 432-1.
  void wideGamutMatricesArePublished() {
    expectMatrix("Linear Rec.2020",
                 {1.660491, -0.587641, -0.072850, -0.124550, 1.132900, -0.008349, -0.018151,
                  -0.100579, 1.118730},
                 1e-5);
    expectMatrix(
        "Linear P3-D65",
        {1.2249402, -0.2249402, 0.0, -0.0420570, 1.0420570, 0.0, -0.0196376, -0.0786360, 1.0982736},
        1e-5);
  }

  // Adobe RGB (1998) colour image encoding, §4.3.5.3.
  void adobePrimariesArePublished() {
    const Eigen::Matrix3d xyz = xyzFromRgb(kAdobeRgb);
    const std::array<double, 9> published = {0.57667, 0.18556, 0.18823, 0.29734, 0.62736,
                                             0.07529, 0.02703, 0.07069, 0.99134};
    for (int i = 0; i < 9; ++i) {
      EXPECT_NEAR(xyz(i / 3, i % 3), published[static_cast<std::size_t>(i)], 1e-5);
    }
    EXPECT_NEAR(toLinear("Adobe RGB (1998)", {0.5f, 0.5f, 0.5f})[1], std::pow(0.5, 563.0 / 256.0),
                1e-6);
  }

  void displayP3IsP3WithTheCurveOfSrgb() {
    const Rgb display = toLinear("Display P3", {0.8f, 0.4f, 0.2f});
    const Rgb linear = toLinear("Linear P3-D65", {static_cast<float>(decodeSrgb(0.8f)),
                                                  static_cast<float>(decodeSrgb(0.4f)),
                                                  static_cast<float>(decodeSrgb(0.2f))});
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(display[k], linear[k], 1e-6);
  }

  void whiteStaysWhite() {
    for (const std::string& name : ofUnitLight()) {
      for (const float value : toLinear(name, {1, 1, 1}))
        EXPECT_NEAR(value, 1.0, 1e-6);
      for (const float value : fromLinear(name, {1, 1, 1}))
        EXPECT_NEAR(value, 1.0, 1e-6);
    }
  }

  void thereAndBackIsTheSame() {
    for (const std::string& name : ofUnitLight()) {
      for (const Rgb& rgb : {Rgb{0.3f, 0.2f, 0.1f}, Rgb{1.5f, 0.0f, 0.4f}, Rgb{0.001f, 0.5f, 0.9f},
                             Rgb{-0.05f, 0.6f, 0.2f}}) {
        const Rgb back = fromLinear(name, toLinear(name, rgb));
        for (std::size_t k = 0; k < 3; ++k)
          EXPECT_NEAR(back[k], rgb[k], 1e-5);
      }
    }
  }

  // Signals of ITU-R BT.2100 and BT.2408, table 1: PQ of 100, 203, 1000 and 10000 cd/m².
  void videoIsTheStandardsCurve() {
    const auto grey = [](const char* name, float number) {
      return double{toLinear(name, {number, number, number})[1]};
    };
    for (const auto& [signal, light] : {std::pair{0.50808, 100.0 / 203.0},
                                        {0.58069, 1.0},
                                        {0.75183, 1000.0 / 203.0},
                                        {1.0, 10000.0 / 203.0},
                                        {0.0, 0.0}}) {
      EXPECT_NEAR(grey("Rec.2100 PQ", static_cast<float>(signal)), light, 2e-4 * light + 1e-9);
    }
    // The inverse of the camera's curve: 1/12 of its range at 0.5, all of it at 1.
    const double white = (std::exp((0.75 - 0.55991073) / 0.17883277) + 0.28466892) / 12.0;
    for (const auto& [signal, light] : {std::pair{0.5, 1.0 / 12.0 / white},
                                        {0.75, 1.0},
                                        {1.0, 1.0 / white},
                                        {0.25, 1.0 / 48.0 / white}}) {
      EXPECT_NEAR(grey("Rec.2100 HLG", static_cast<float>(signal)), light, 1e-5 * light);
    }
    for (const char* name : {"Rec.2100 PQ", "Rec.2100 HLG"}) {
      for (float number = 0.0f; number <= 1.0f; number += 1.0f / 64.0f) {
        const auto light = static_cast<float>(grey(name, number));
        EXPECT_NEAR(fromLinear(name, {light, light, light})[1], number, 1e-5);
      }
    }
    EXPECT_NEAR(grey("Rec.2100 HLG", -0.5f), -grey("Rec.2100 HLG", 0.5f), 1e-7);
  }

  void narrowRangeIsExpanded() {
    const ColorSpace narrow = inNarrowRange(builtInColorSpace("sRGB"), 16.0 / 255.0, 235.0 / 255.0);
    QCOMPARE(narrow.name, std::string("sRGB, narrow range"));
    QVERIFY(!narrow.isNamed);
    std::vector<float> rgb = {16.0f / 255.0f, 235.0f / 255.0f, 125.5f / 255.0f};
    const std::vector<float> numbers = rgb;
    EXPECT_OK(narrow.toLinearRec709(rgb));
    EXPECT_NEAR(rgb[0], 0.0, 1e-7);
    EXPECT_NEAR(rgb[1], 1.0, 1e-6);
    EXPECT_NEAR(rgb[2], 0.21404, 1e-5);
    EXPECT_OK(narrow.fromLinearRec709(rgb));
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(rgb[k], numbers[k], 1e-6);
  }

  void linearRec709AndRawChangeNoBit() {
    const Rgb rgb = {0.123456789f, -3.0f, 7e30f};
    for (const char* name : {"Linear Rec.709", "Raw"}) {
      QCOMPARE(toLinear(name, rgb), rgb);
      QCOMPARE(fromLinear(name, rgb), rgb);
    }
  }

  void notANumberStaysInItsPixel() {
    for (const std::string& name : builtIn()) {
      const auto converter = toLinearRec709(name, "test");
      EXPECT_OK(converter);
      std::vector<float> pixels = {
          0.5f, 0.4f, 0.3f, std::numeric_limits<float>::quiet_NaN(), 0.4f, 0.3f, 0.5f, 0.4f, 0.3f};
      EXPECT_OK(converter.value()(pixels));
      QVERIFY(std::isnan(pixels[3]));
      for (std::size_t k = 0; k < 3; ++k) {
        QVERIFY(std::isfinite(pixels[k]));
        QCOMPARE(pixels[k], pixels[6 + k]);
      }
    }
  }

  void spellingsOfOneNameAreOneSpace() {
    const std::vector<std::pair<std::string, std::string>> spellings = {
        {"srgb", "sRGB"},
        {"SRGB ", "sRGB"},
        {"sRGB IEC61966-2.1", "sRGB"},
        {"sRGB - Texture", "sRGB"},
        {"lin_rec709", "Linear Rec.709"},
        {"lin_srgb", "Linear Rec.709"},
        {"Linear", "Linear Rec.709"},
        {"LINEAR-REC-709", "Linear Rec.709"},
        {"Linear Rec.709 (sRGB)", "Linear Rec.709"},
        {"acescg", "ACEScg"},
        {"ACES - ACEScg", "ACEScg"},
        {"lin_ap1", "ACEScg"},
        {"aces2065_1", "ACES2065-1"},
        {"lin_rec2020", "Linear Rec.2020"},
        {"linear p3 d65", "Linear P3-D65"},
        {"display_p3", "Display P3"},
        {"Adobe RGB", "Adobe RGB (1998)"},
        {"Gamma2.2", "Gamma 2.2 Rec.709"},
        {"none", "Raw"},
    };
    for (const auto& [spelling, name] : spellings) {
      const auto canonical = canonicalColorSpace(spelling, "test");
      EXPECT_OK(canonical);
      QCOMPARE(canonical.value(), name);
    }
    for (const std::string& name : builtIn()) {
      QCOMPARE(canonicalColorSpace(name, "test").value(), name);
    }
  }

  void unknownNamesAreAnsweredWithKnownOnes() {
    const auto wrong = toLinearRec709("ACEScgg", "--colorspace");
    EXPECT_ERROR(wrong, "--colorspace: unknown colour space 'ACEScgg'; did you mean 'ACEScg'?");
    QVERIFY(wrong.error().kind == ErrorKind::input);
    EXPECT_ERROR(fromLinearRec709("", "--colorspace"), "sRGB");
    EXPECT_ERROR(canonicalColorSpace("XYZZY plugh 12345", "x"), "known: sRGB");
  }

  void environmentsConfigurationIsUsed() {
    useConfig(kStudioConfig);
    // Twice ACES2065-1.
    const Rgb twice = toLinear("studio", {0.1f, 0.2f, 0.3f});
    const Rgb once = toLinear("ACES2065-1", {0.2f, 0.4f, 0.6f});
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(twice[k], once[k], 1e-6);
    const Rgb back = fromLinear("our_space", twice);
    EXPECT_NEAR(back[0], 0.1, 1e-6);
    EXPECT_NEAR(back[2], 0.3, 1e-6);
    QCOMPARE(canonicalColorSpace("our_space", "test").value(), std::string("studio"));
    QCOMPARE(canonicalColorSpace("scene_linear", "test").value(), std::string("studio"));
    const auto names = colorSpaceNames();
    QVERIFY(std::find(names.begin(), names.end(), "studio") != names.end());
    QCOMPARE(names.front(), std::string("sRGB"));
  }

  // A studio's own sRGB is what the studio says; where both mean the same there is one name.
  void configurationsComeBeforeBuiltIns() {
    const QByteArray own = QByteArray(kStudioConfig).replace("name: studio", "name: sRGB");
    useConfig(QByteArray(own).replace("scene_linear: studio", "scene_linear: sRGB"));
    const auto space = namedColorSpace("sRGB", "test");
    EXPECT_OK(space);
    QCOMPARE(space.value().name, std::string("sRGB ($OCIO)"));
    const Rgb twice = toLinear("sRGB", {0.1f, 0.2f, 0.3f});
    const Rgb once = toLinear("ACES2065-1", {0.2f, 0.4f, 0.6f});
    for (std::size_t k = 0; k < 3; ++k)
      EXPECT_NEAR(twice[k], once[k], 1e-6);
    QCOMPARE(toLinear("sRGB ($OCIO)", {0.1f, 0.2f, 0.3f}), twice);
    QCOMPARE(namedColorSpace("ACES2065-1", "test").value().name, std::string("ACES2065-1"));
    QVERIFY(namedColorSpace("ACES2065-1", "test").value().matrix != nullptr);
    // What a file calls sRGB is the standard's.
    EXPECT_NEAR(builtInColorSpace("sRGB").matrix->curves[0].toLight(0.5), 0.214041140, 1e-7);
    qunsetenv("OCIO");
    EXPECT_ERROR(namedColorSpace("sRGB ($OCIO)", "test"), "unknown colour space");
  }

  void oldConfigurationsAreTiedByTheirOwnRec709() {
    useConfig(kOldConfig);
    EXPECT_NEAR(toLinear("halved", {0.1f, 0.2f, 0.3f})[1], 0.4, 1e-6);
    EXPECT_NEAR(fromLinear("halved", {0.1f, 0.2f, 0.3f})[1], 0.1, 1e-6);
  }

  void configurationsWithoutATieAreRefused() {
    useConfig(QByteArray(kStudioConfig).replace("aces_interchange: ACES2065-1", "data: raw"));
    EXPECT_ERROR(toLinearRec709("studio", "--colorspace"), "aces_interchange");
  }

  void missingTablesOfAConfigurationAreTold() {
    useConfig(kStudioConfig);
    EXPECT_ERROR(toLinearRec709("broken", "--colorspace"), "missing.cube");
  }

  void hostileConfigurationsAreSentences_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("empty") << QByteArray();
    QTest::newRow("not YAML") << QByteArray("{{{{ : :: \x01\x02");
    QTest::newRow("binary") << QByteArray(5000, '\xff');
    QTest::newRow("list") << QByteArray("- a\n- b\n");
    QTest::newRow("number") << QByteArray("42");
    QTest::newRow("deep") << QByteArray(200000, '[');
    QTest::newRow("deep maps") << QByteArray("a: ").repeated(1) + QByteArray(100000, '{');
    QTest::newRow("newer") << QByteArray(kStudioConfig).replace("version: 2", "version: 9");
    QTest::newRow("no version") << QByteArray(kStudioConfig).mid(24);
    QTest::newRow("wrong types") << QByteArray(
        "ocio_profile_version: 2\ncolorspaces: 7\nroles: [1, 2]\ndisplays: x\n");
    QTest::newRow("wrong matrix") << QByteArray(kStudioConfig).replace("[2,0,0,0,", "[nan, x,");
    QTest::newRow("cut off") << QByteArray(kStudioConfig).left(400);
    QTest::newRow("itself") << QByteArray(kStudioConfig)
                                   .replace("!<FileTransform> {src: missing.cube}",
                                            "!<ColorSpaceTransform> {src: broken, dst: studio}");
  }
  void hostileConfigurationsAreSentences() {
    QFETCH(QByteArray, text);
    useConfig(text);
    const auto wanted = toLinearRec709("broken", "--colorspace");
    QVERIFY(wanted.failed());
    const std::string sentence = wanted.error().text();
    QVERIFY2(sentence.find('\n') == std::string::npos, sentence.c_str());
    // What needs no configuration goes on working.
    EXPECT_OK(toLinearRec709("sRGB", "test"));
    QVERIFY(colorSpaceNames().size() >= 10);
  }

  void pathsThatAreNoConfigurationAreTold() {
    qputenv("OCIO", folder_.filePath("nothing.ocio").toUtf8());
    EXPECT_ERROR(toLinearRec709("studio", "--colorspace"), "there is no file");
    qputenv("OCIO", folder_.path().toUtf8());
    EXPECT_ERROR(toLinearRec709("studio", "--colorspace"), "is not a file");
    qputenv("OCIO", "ocio://default");
    EXPECT_ERROR(toLinearRec709("studio", "--colorspace"), "$OCIO");
  }

  void convertersServeManyThreads() {
    useConfig(kStudioConfig);
    for (const char* name : {"studio", "ACEScg", "sRGB"}) {
      const auto converter = toLinearRec709(name, "test");
      EXPECT_OK(converter);
      std::vector<float> expected;
      for (int i = 0; i < 3000; ++i)
        expected.push_back(static_cast<float>(i) / 3000.0f);
      const std::vector<float> source = expected;
      EXPECT_OK(converter.value()(expected));
      std::vector<std::vector<float>> results(8, source);
      std::vector<std::jthread> threads;
      for (std::vector<float>& pixels : results) {
        threads.emplace_back([&] { (void)bool(converter.value()(pixels)); });
      }
      threads.clear();
      for (const std::vector<float>& pixels : results)
        QCOMPARE(pixels, expected);
    }
  }
};

CUTIS_TEST(ColorSpaceTest)

}  // namespace
}  // namespace cutis

#include "color_space_test.moc"
