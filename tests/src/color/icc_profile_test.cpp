// Profiles written byte by byte against the equations they stand for.

#include "src/color/icc_profile.h"

#include <Eigen/LU>
#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/icc_bytes.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using Chromaticities = std::array<double, 8>;

struct NamedPrimaries {
  const char* name;
  Chromaticities chromaticities;
};

const std::vector<NamedPrimaries>& primaries() {
  static const std::vector<NamedPrimaries> all = {
      {"Rec709", kRec709.chromaticities},
      {"Adobe", kAdobeRgb.chromaticities},
      {"P3", kP3D65.chromaticities},
      {"Rec2020", kRec2020.chromaticities},
      {"ACEScg", kAcesCg.chromaticities},
      {"ProPhoto", {0.7347, 0.2653, 0.1596, 0.8404, 0.0366, 0.0001, 0.3457, 0.3585}},
      {"NTSC", {0.67, 0.33, 0.21, 0.71, 0.14, 0.08, 0.310, 0.316}},
      {"PAL", {0.64, 0.33, 0.29, 0.60, 0.15, 0.06, 0.3127, 0.3290}}};
  return all;
}

double srgbLight(double v) {
  return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
}

struct NamedCurve {
  const char* name;
  int leastVersion;
  std::string tag;
  std::function<double(double)> light;
};

// The curve types of ICC.1:2022, §10.6 and table 68.
const std::vector<NamedCurve>& curves() {
  const auto power = [](double g) { return [g](double v) { return std::pow(v, g); }; };
  static const std::vector<NamedCurve> all = {
      {"curv linear", 2, test::curveTag({}), power(1.0)},
      {"curv 1.8", 2, test::curveTag({461}), power(461.0 / 256.0)},
      {"curv 2.2", 2, test::curveTag({563}), power(563.0 / 256.0)},
      {"curv sRGB", 2, test::sampledTag(1024, srgbLight), srgbLight},
      {"curv 2.4", 2, test::sampledTag(4096, power(2.4)), power(2.4)},
      {"para 0", 4, test::parametricTag(0, {2.2}), power(2.2)},
      {"para 1", 4, test::parametricTag(1, {2.0, 0.9, 0.1}),
       [](double v) { return std::pow(0.9 * v + 0.1, 2.0); }},
      {"para 1 with a toe", 4, test::parametricTag(1, {2.0, 1.1, -0.1}),
       [](double v) { return v >= 0.1 / 1.1 ? std::pow(1.1 * v - 0.1, 2.0) : 0.0; }},
      {"para 2", 4, test::parametricTag(2, {2.0, 0.9, 0.05, 0.0975}),
       [](double v) { return std::pow(0.9 * v + 0.05, 2.0) + 0.0975; }},
      {"para 3", 4, test::parametricTag(3, {2.4, 1.0 / 1.055, 0.055 / 1.055, 1.0 / 12.92, 0.04045}),
       srgbLight},
      {"para 4", 4,
       test::parametricTag(4, {1.0 / 0.45, 1.0 / 1.099, 0.099 / 1.099, 1.0 / 4.5, 0.081, 0.0, 0.0}),
       [](double v) { return v >= 0.081 ? std::pow((v + 0.099) / 1.099, 1.0 / 0.45) : v / 4.5; }},
      {"para 4 with an offset", 4,
       test::parametricTag(4, {2.0, 0.95, 0.02, 0.3, 0.1, 0.0291, 0.012325}), [](double v) {
         return v >= 0.1 ? std::pow(0.95 * v + 0.02, 2.0) + 0.0291 : 0.3 * v + 0.012325;
       }}};
  return all;
}

// Numbers from black to white, pure and mixed.
std::vector<float> numbers() {
  std::vector<float> rgb;
  for (const float r : {0.0f, 0.02f, 0.1f, 0.35f, 0.62f, 1.0f}) {
    for (const float g : {0.0f, 0.05f, 0.2f, 0.5f, 0.81f, 1.0f}) {
      for (const float b : {0.0f, 0.01f, 0.3f, 0.7f, 1.0f})
        rgb.insert(rgb.end(), {r, g, b});
    }
  }
  return rgb;
}

class IccProfileTest : public QObject {
  Q_OBJECT

 private slots:
  void matrixProfilesAreTheirEquations_data() {
    QTest::addColumn<int>("version");
    QTest::addColumn<int>("primaries");
    QTest::addColumn<int>("curve");
    for (const int version : {2, 4}) {
      for (std::size_t p = 0; p < primaries().size(); ++p) {
        for (std::size_t c = 0; c < curves().size(); ++c) {
          if (curves()[c].leastVersion > version) continue;
          QTest::addRow("v%d %s %s", version, primaries()[p].name, curves()[c].name)
              << version << int(p) << int(c);
        }
      }
    }
  }
  void matrixProfilesAreTheirEquations() {
    QFETCH(int, version);
    QFETCH(int, primaries);
    QFETCH(int, curve);
    const Chromaticities& chromaticities =
        cutis::primaries()[static_cast<std::size_t>(primaries)].chromaticities;
    const NamedCurve& named = curves()[static_cast<std::size_t>(curve)];
    // The name must not matter.
    const std::string bytes = test::matrixProfile(version, chromaticities, named.tag, "sRGB");
    const auto profile = readIccProfile(bytes, "test");
    EXPECT_OK(profile);
    QVERIFY(profile.value().kind == ProfileKind::rgb);
    QCOMPARE(profile.value().description, std::string("sRGB"));
    const Eigen::Matrix3d matrix = rgbFromRgb(kRec709, {"", chromaticities});
    const std::vector<float> stored = numbers();
    std::vector<float> light = stored;
    EXPECT_OK(profile.value().space.toLinearRec709(light));
    double worst = 0.0;
    for (std::size_t i = 0; i < stored.size(); i += 3) {
      const Eigen::Vector3d truth =
          matrix * Eigen::Vector3d(named.light(stored[i]), named.light(stored[i + 1]),
                                   named.light(stored[i + 2]));
      for (std::size_t c = 0; c < 3; ++c)
        worst = std::max(worst, std::abs(light[i + c] - truth[static_cast<Eigen::Index>(c)]));
    }
    EXPECT_AT_MOST(worst, 1e-3);
    // And back to the same light.
    std::vector<float> back = light;
    EXPECT_OK(profile.value().space.fromLinearRec709(back));
    EXPECT_OK(profile.value().space.toLinearRec709(back));
    for (std::size_t i = 0; i < back.size(); ++i)
      EXPECT_NEAR(back[i], light[i], 2e-5);
  }

  void thereAreAtLeastFortyOfThem() {
    std::size_t count = 0;
    for (const NamedCurve& curve : curves())
      count += (curve.leastVersion == 2 ? 2 : 1) * primaries().size();
    QVERIFY(count >= 40);
  }

  // Steps of 8 and 16 bits come back as themselves.
  void numbersComeBack() {
    for (const NamedCurve& curve : curves()) {
      const std::string bytes = test::matrixProfile(4, kRec2020.chromaticities, curve.tag, "any");
      const auto profile = readIccProfile(bytes, "test");
      EXPECT_OK(profile);
      if (curve.light(0.05) == curve.light(0.06)) continue;  // a toe keeps nothing apart
      for (int step = 16; step < 256; ++step) {
        std::vector<float> rgb(3, static_cast<float>(step) / 255.0f);
        EXPECT_OK(profile.value().space.toLinearRec709(rgb));
        EXPECT_OK(profile.value().space.fromLinearRec709(rgb));
        EXPECT_NEAR(rgb[1] * 65535.0, step * 257.0, 0.5);
      }
    }
  }

  void spacesOfOurOwnAreRecognisedByTheirNumbers() {
    const auto nameOf = [](const Chromaticities& p, const std::string& curve) {
      return readIccProfile(test::matrixProfile(2, p, curve, "calibrated"), "test")
          .value()
          .space.name;
    };
    const std::string srgb = test::sampledTag(1024, srgbLight);
    QCOMPARE(nameOf(kRec709.chromaticities, srgb), std::string("sRGB"));
    QCOMPARE(nameOf(kP3D65.chromaticities, srgb), std::string("Display P3"));
    QCOMPARE(nameOf(kAdobeRgb.chromaticities, test::curveTag({563})),
             std::string("Adobe RGB (1998)"));
    QCOMPARE(nameOf(kRec709.chromaticities, test::curveTag({})), std::string("Linear Rec.709"));
    QCOMPARE(nameOf(kRec2020.chromaticities, srgb),
             std::string("the space of the ICC profile 'calibrated'"));
  }

  void oursAreReadAgain() {
    for (const char* name : {"sRGB", "Linear Rec.709", "ACEScg", "Display P3", "Linear Rec.2020",
                             "Adobe RGB (1998)", "Gamma 2.2 Rec.709", "ACES2065-1"}) {
      const std::string bytes = iccProfileOf(builtInColorSpace(name));
      QVERIFY2(!bytes.empty(), name);
      QCOMPARE(iccProfileOf(builtInColorSpace(name)), bytes);
      const auto profile = readIccProfile(bytes, "test");
      EXPECT_OK(profile);
      QCOMPARE(profile.value().space.name, std::string(name));
      EXPECT_AT_MOST(differenceOf(profile.value().space, builtInColorSpace(name)), 2e-4);
    }
  }

  // Device numbers that are linear in XYZ behind a curve, so that any interpolation is exact.
  void tablesAreFollowedAndInverted() {
    const Eigen::Matrix3d colorants =
        adaptationMatrix(ChromaticAdaptation::bradford, kRec709.xyzOfWhite(), test::iccD50()) *
        xyzFromRgb(kRec709);
    const auto xyz = [&](std::array<double, 4> n) -> Eigen::Vector3d {
      return (colorants * Eigen::Vector3d(n[0], n[1], n[2])).cwiseMax(0.0);
    };
    const auto curve = [](double v) { return v * v; };
    const std::string bytes = test::tableProfile(3, xyz, curve, "sRGB");
    const auto profile = readIccProfile(bytes, "test");
    EXPECT_OK(profile);
    const ColorSpace& space = profile.value().space;
    QVERIFY(!space.matrix);
    const Eigen::Matrix3d matrix = rgbFromRgb(kRec709, kRec709);
    for (const Eigen::Vector3d& n :
         {Eigen::Vector3d(0.3, 0.5, 0.7), Eigen::Vector3d(1, 1, 1), Eigen::Vector3d(0.8, 0.6, 0.5),
          Eigen::Vector3d(0.1, 0.2, 0.15), Eigen::Vector3d(0.9, 0.1, 0.2)}) {
      std::vector<float> rgb = {float(n[0]), float(n[1]), float(n[2])};
      EXPECT_OK(space.toLinearRec709(rgb));
      const Eigen::Vector3d truth = matrix * n.cwiseProduct(n);
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(rgb[c], truth[static_cast<Eigen::Index>(c)], 1e-3);
      EXPECT_OK(space.fromLinearRec709(rgb));
      for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(rgb[c], n[static_cast<Eigen::Index>(c)], 5e-4);
    }
  }

  void inksAreConverted() {
    const auto xyz = [](std::array<double, 4> ink) -> Eigen::Vector3d {
      return test::iccD50() *
             ((1 - 0.7 * ink[0]) * (1 - 0.5 * ink[1]) * (1 - 0.2 * ink[2]) * (1 - 0.9 * ink[3]));
    };
    const std::string bytes = test::tableProfile(
        4, xyz, [](double v) { return v; }, "press");
    const auto profile = readIccProfile(bytes, "test");
    EXPECT_OK(profile);
    QVERIFY(profile.value().kind == ProfileKind::cmyk && profile.value().space.empty());
    const std::vector<float> inks = {0, 0, 0, 0, 1, 0, 0, 0, 0, 0.5f, 0, 0, 0, 0, 0, 1};
    std::vector<float> rgb(12);
    profile.value().inksToLinearRec709(inks, rgb);
    const std::array<double, 4> truth = {1.0, 0.3, 0.75, 0.1};
    for (std::size_t i = 0; i < 12; ++i)
      EXPECT_NEAR(rgb[i], truth[i / 3], 1e-3);
  }

  void greyIsItsCurve() {
    for (const NamedCurve& curve : curves()) {
      const auto profile = readIccProfile(test::greyProfile(4, curve.tag, "dots"), "test");
      EXPECT_OK(profile);
      QVERIFY(profile.value().kind == ProfileKind::grey);
      std::vector<float> rgb(3, 0.4f);
      EXPECT_OK(profile.value().space.toLinearRec709(rgb));
      for (const float value : rgb)
        EXPECT_NEAR(value, curve.light(0.4), 1e-3);
      QVERIFY(profile.value().space.profile && !profile.value().space.profile->empty());
    }
  }

  // Every damage is a sentence, or numbers; never a crash.
  void damagedProfilesAreSentences() {
    const std::string sound =
        test::matrixProfile(2, kRec709.chromaticities, test::sampledTag(64, srgbLight), "any");
    QVERIFY(readIccProfile("", "a").failed());
    QVERIFY(readIccProfile("short", "a").failed());
    for (const std::size_t length : {100u, 128u, 140u, 250u})
      QVERIFY(readIccProfile(sound.substr(0, length), "a").failed());
    std::string noMark = sound;
    noMark[36] = 'x';
    EXPECT_ERROR(readIccProfile(noMark, "a.png"), "a.png: it does not begin like an ICC profile");
    for (std::size_t at = 0; at < sound.size(); at += 3) {
      std::string damaged = sound;
      damaged[at] = static_cast<char>(damaged[at] ^ 0xff);
      const auto result = readIccProfile(damaged, "a");
      if (!result || result.value().space.empty()) continue;
      std::vector<float> rgb(3, 0.5f);
      QVERIFY(bool(result.value().space.toLinearRec709(rgb)));
      QVERIFY(bool(result.value().space.fromLinearRec709(rgb)));
    }
  }

  void profilesOfNothingAreRefused() {
    const std::string same = test::xyzTag(test::iccD50() / 3.0), linear = test::curveTag({});
    const std::string grey = test::iccBytes(2, "RGB ", "XYZ ",
                                            {{"rXYZ", same},
                                             {"gXYZ", same},
                                             {"bXYZ", same},
                                             {"rTRC", linear},
                                             {"gTRC", linear},
                                             {"bTRC", linear}});
    EXPECT_ERROR(readIccProfile(grey, "a"), "its primaries span no colours");
    const std::string flat = test::sampledTag(16, [](double) { return 0.5; });
    EXPECT_ERROR(readIccProfile(test::matrixProfile(2, kRec709.chromaticities, flat, "flat"), "a"),
                 "a curve of it does not rise");
  }
};

CUTIS_TEST(IccProfileTest)

}  // namespace
}  // namespace cutis

#include "icc_profile_test.moc"
