#include "src/files/profiles/profile_file.h"

#include <cmath>
#include <utility>
#include <vector>

#include <QRegularExpression>
#include <QtTest>

#include "core/skin/model/compiled_model.h"
#include "core/skin/profile/profile_signature.h"
#include "src/files/io/text_file.h"
#include "src/files/resources.h"
#include "tests/support/expect.h"
#include "tests/support/folders.h"
#include "tests/support/models.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

std::string paper() {
  return std::string(*resource("profiles/li2024.json"));
}

const std::string kMeasured = test::sourceFolder() / "tests/support/two_layer_profile.json";

std::string measured() {
  return readTextFile(kMeasured).value();
}

std::string changedProfile(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  if (at == std::string::npos) return "test is wrong: " + from;
  return text.replace(at, from.size(), to);
}

class ProfileFileTest : public QObject {
  Q_OBJECT

 private slots:
  // The parameters and constants of resources/manual/model.md.
  void li2024IsThePapersModel() {
    const Profile& profile = test::li2024().profile();
    QCOMPARE(profile.name, std::string("li2024"));
    const double maxima[] = {0.5, 1.0, 0.5, 0.3, 0.01};
    const int samples[] = {51, 11, 51, 4, 5}, exponents[] = {3, 1, 3, 1, 3};
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      EXPECT_NEAR(profile.axes[k].maximum, maxima[k], 0.0);
      QCOMPARE(profile.axes[k].samples, samples[k]);
      QCOMPARE(profile.axes[k].exponent, exponents[k]);
    }
    EXPECT_NEAR(profile.eumelanin.coefficient, 6.6e10, 0.0);
    EXPECT_NEAR(profile.pheomelanin.exponent, -4.75, 0.0);
    EXPECT_NEAR(profile.dermalBlood.oxygenation, 0.75, 0.0);
    EXPECT_NEAR(profile.epidermalBlood.oxygenation, 0.75, 0.0);
    EXPECT_NEAR(profile.epidermalThicknessMm, 0.32, 0.0);
    EXPECT_NEAR(profile.refractiveIndex, 1.4, 0.0);
    EXPECT_NEAR(profile.dermalScatteringRatio, 0.5, 0.0);
    QVERIFY(!profile.dermalScatteringLaw);
    QVERIFY(profile.layerOptics == LayerOpticsKind::diffusion);
    QVERIFY(profile.prior.correlation.isIdentity(0.0));
    QVERIFY(profile.prior.scale == PriorScale::log);
  }

  void namesAndFilesGiveTheSameModel() {
    const std::vector<std::string> shipped = {"li2024", "skin2026", "skin2026b"};
    QVERIFY(profileNames() == shipped);
    const test::ScratchFolder folder;
    const auto path = folder.write("copy.json", paper());
    const auto copy = loadProfile(path.string(), "--profile");
    EXPECT_OK(copy);
    QCOMPARE(fingerprint(copy.value()), fingerprint(test::li2024().profile()));
    QVERIFY(profileText("li2024", "t").value() == paper());
    QVERIFY(profileText(path.string(), "t").value() == paper());
  }

  // Every constant of the file, as it stands there.
  void allConstantsAreRead() {
    const auto loaded = loadProfile(kMeasured, "test");
    EXPECT_OK(loaded);
    const Profile& p = loaded.value();
    QCOMPARE(p.name, std::string("two-layer"));
    QVERIFY(p.layerOptics == LayerOpticsKind::addingDoubling);
    for (std::size_t k = 0; k < kParameterCount; ++k) {
      EXPECT_NEAR(p.axes[k].maximum, test::li2024().profile().axes[k].maximum, 0.0);
    }
    const auto isLaw = [](const PowerLaw& law, double coefficient, double exponent, double at) {
      return law.coefficient == coefficient && law.exponent == exponent && law.referenceNm == at;
    };
    QVERIFY(isLaw(p.eumelanin, 67.91627, -2.0, 500.0));
    QVERIFY(isLaw(p.pheomelanin, 2.9e14, -4.75, 1.0));
    QVERIFY(isLaw(p.epidermalScatteringLaw.mie, 5.2, -1.25, 550.0));
    QVERIFY(isLaw(p.epidermalScatteringLaw.rayleigh, 0.0, -4.0, 550.0));
    QVERIFY(p.dermalScatteringLaw.has_value());
    QVERIFY(isLaw(p.dermalScatteringLaw->mie, 2.585, -0.71, 550.0));
    QVERIFY(isLaw(p.dermalScatteringLaw->rayleigh, 2.115, -4.0, 550.0));
    const std::vector<std::pair<double, double>> values = {{p.baseline.constant, 0.0244},
                                                           {p.baseline.tail.amplitude, 8.53},
                                                           {p.baseline.tail.originNm, 154},
                                                           {p.baseline.tail.decayNm, 66.2},
                                                           {p.bloodSmoothingNm, 4.25},
                                                           {p.caroteneInSkin.scale, 3},
                                                           {p.caroteneInSkin.shiftNm, 24},
                                                           {p.caroteneInSkin.smoothingNm, 8},
                                                           {p.fat.peak, 0.012},
                                                           {p.fat.centreNm, 920},
                                                           {p.fat.deviationNm, 22},
                                                           {p.epidermalThicknessMm, 0.093},
                                                           {p.epidermalWater, 0.2},
                                                           {p.epidermalBlood.oxygenation, 0.7},
                                                           {p.epidermalBlood.vesselRadiusMm, 0.004},
                                                           {p.epidermalUltraviolet.amplitude, 1.66},
                                                           {p.epidermalUltraviolet.originNm, 360},
                                                           {p.epidermalUltraviolet.decayNm, 28},
                                                           {p.dermalWater, 0.67},
                                                           {p.dermalBlood.oxygenation, 0.6},
                                                           {p.dermalBlood.vesselRadiusMm, 0.016},
                                                           {p.dermalBaselineFactor, 0.48},
                                                           {p.dermalFat, 0.78},
                                                           {p.refractiveIndex, 1.4}};
    for (std::size_t k = 0; k < values.size(); ++k) {
      QVERIFY2(values[k].first == values[k].second, std::to_string(k).c_str());
    }
    QVERIFY(p.prior.isLog(kMelanin) && !p.prior.isLog(kMelaninBlend) && !p.prior.isLog(kCarotene));
    EXPECT_NEAR(std::log(p.prior.mean[kHaemoglobinEpidermal]), -3.8246, 1e-4);
    EXPECT_NEAR(p.prior.mean[kCarotene], 0.0027, 0.0);
    EXPECT_NEAR(p.prior.deviation[kHaemoglobinDermal], 0.6684, 0.0);
    EXPECT_NEAR(p.prior.correlation(kMelanin, kMelaninBlend), -0.468, 0.0);
    EXPECT_NEAR(p.prior.correlation(kCarotene, kHaemoglobinEpidermal), 0.3, 0.0);
    // A copy elsewhere is the same profile.
    const test::ScratchFolder folder;
    const auto copy = loadProfile(folder.write("copy.json", measured()).string(), "test");
    EXPECT_OK(copy);
    QCOMPARE(fingerprint(copy.value()), fingerprint(p));
  }

  // What is left out means the paper's model.
  void defaultsAreThePapersModel() {
    std::string text = paper();
    for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{
             {"\"exponent\": -3.33", "\"exponent\": -3.33, \"at_nm\": 1"},
             {"\"oxygenation\": 0.75",
              "\"blood_smoothing_nm\": 0, \"carotene\": {\"scale\": 1, "
              "\"shift_nm\": 0}, \"fat\": {\"peak\": 1, \"centre_nm\": "
              "900, \"deviation_nm\": 20}"},
             {"\"thickness_mm\"",
              "\"blood\": {\"oxygenation\": 0.75, \"vessel_radius_mm\": 0}, "
              "\"ultraviolet\": {\"amplitude\": 0, \"origin_nm\": 360, "
              "\"decay_nm\": 20}, \"thickness_mm\""},
             {"\"scattering_ratio\"",
              "\"blood\": {\"oxygenation\": 0.75}, \"baseline_factor\": 1, "
              "\"fat_fraction\": 0, \"scattering_ratio\""}}) {
      text = changedProfile(text, from, to);
    }
    const auto profile = parseProfile(text, "p.json");
    EXPECT_OK(profile);
    QCOMPARE(fingerprint(profile.value()), fingerprint(test::li2024().profile()));
  }

  // Laws of its own that say what the ratio says: the same light.
  void dermalLawsReplaceTheRatio() {
    const auto profile = parseProfile(
        changedProfile(paper(), "\"scattering_ratio\": 0.5",
                       "\"mie_scattering\": {\"coefficient\": 7.37, \"exponent\": -0.22}, "
                       "\"rayleigh_scattering\": {\"coefficient\": 1.1e11, \"exponent\": -4}"),
        "p.json");
    EXPECT_OK(profile);
    const SkinModel model(profile.value());
    const ParameterVector skin = {0.05, 0.6, 0.03, 0.02, 0.001};
    const Spectrum found = model.reflectance(skin), paper = test::li2024().reflectance(skin);
    QVERIFY((found - paper).abs().maxCoeff() < 1e-14);
    const CompiledModel nodes(model, {0, 175, 350});
    const CompiledModel same(test::li2024(), {0, 175, 350});
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(nodes.nodes<double>()[k].dermalScattering,
                  same.nodes<double>()[k].dermalScattering, 1e-13);
    }
  }

  void unknownNamesSuggest() {
    EXPECT_ERROR(loadProfile("li2042", "--profile"),
                 "--profile: unknown profile 'li2042'; did you mean 'li2024'?");
    EXPECT_ERROR(loadProfile("gone.json", "--profile"), "gone.json: there is no such file");
  }

  void chromophoresLieBesideTheFile() {
    const test::ScratchFolder folder;
    folder.write("sub/p.json", changedProfile(paper(), "\"chromophores\": \"chromophores\"",
                                              "\"chromophores\": \"pigments.csv\""));
    const auto missing = loadProfile((folder / "sub/p.json").string(), "t");
    EXPECT_ERROR(missing, (folder / "sub/pigments.csv").string());
    folder.write("sub/pigments.csv",
                 "nm,oxyhaemoglobin,deoxyhaemoglobin,water,carotene\n300,9,9,0,9\n1000,9,9,0,9\n");
    const auto own = loadProfile((folder / "sub/p.json").string(), "t");
    EXPECT_OK(own);
    EXPECT_NEAR(own.value().oxyhaemoglobin[100], 9.0, 1e-12);
    folder.write("sub/pigments.csv", "nm,oxyhaemoglobin,water,carotene\n300,9,0,9\n1000,9,0,9\n");
    EXPECT_ERROR(loadProfile((folder / "sub/p.json").string(), "t"),
                 "the header must name a column deoxyhaemoglobin");
  }

  void errorsNameFileAndField_data() {
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* name, const char* from, const char* to, const char* message) {
      QTest::newRow(name) << from << to << message;
    };
    row("newer", "\"cutis_profile\": 1", "\"cutis_profile\": 9", "newer version");
    row("another kind", "\"cutis_profile\": 1", "\"cutis_rig\": 1",
        "\"cutis_profile\": 1 is missing");
    row("unknown field", "\"dermis\"", "\"Dermis\"", "unknown field 'Dermis'");
    row("no maximum", "\"maximum\": 0.5, ", "", "parameters.melanin.maximum must be a number");
    row("negative maximum", "\"maximum\": 0.5", "\"maximum\": -0.5",
        "parameters.melanin.maximum must be positive");
    row("one sample", "\"samples\": 51", "\"samples\": 1",
        "parameters.melanin.samples must be between 2 and 256");
    row("half a sample", "\"samples\": 51", "\"samples\": 51.5",
        "parameters.melanin.samples must be a whole number");
    row("too many samples", "\"samples\": 51", "\"samples\": 257", "between 2 and 256");
    row("spacing", "\"cubic\"", "\"quartic\"",
        "parameters.melanin.spacing must be \"uniform\", \"quadratic\" or \"cubic\"");
    row("extra parameter", "\"parameters\": {", "\"parameters\": {\"bilirubin\": {}, ",
        "unknown field 'parameters.bilirubin'");
    row("oxygenation", "\"oxygenation\": 0.75", "\"oxygenation\": 1.01",
        "absorption.oxygenation must be between 0 and 1");
    row("water", "\"water_fraction\": 0.2", "\"water_fraction\": -0.2",
        "epidermis.water_fraction must be between 0 and 1");
    row("dermal water", "\"water_fraction\": 0.6", "\"water_fraction\": 1.6",
        "dermis.water_fraction must be between 0 and 1");
    row("index", "\"refractive_index\": 1.4", "\"refractive_index\": 0.9",
        "refractive_index must be between 1 and 2");
    row("ratio", "\"scattering_ratio\": 0.5", "\"scattering_ratio\": 0",
        "dermis.scattering_ratio must be positive");
    row("thin", "\"thickness_mm\": 0.32", "\"thickness_mm\": 0.1",
        "epidermis.thickness_mm must be at least");
    row("no thickness", "\"thickness_mm\": 0.32", "\"thickness_mm\": 0",
        "epidermis.thickness_mm must be between 0 and 10");
    row("scattering", "\"coefficient\": 14.74", "\"coefficient\": -1e6",
        "epidermis.mie_scattering must be such that it scatters 0.001 to 10000 per mm");
    row("much scattering", "\"coefficient\": 14.74", "\"coefficient\": 1e30",
        "epidermis.mie_scattering must be such that it scatters");
    row("much more in the dermis", "\"scattering_ratio\": 0.5", "\"scattering_ratio\": 1e9",
        "dermis.scattering_ratio must be such that it scatters");
    row("infinite scattering", "\"coefficient\": 14.74", "\"coefficient\": 1e308",
        "epidermis.mie_scattering must be such that it scatters");
    row("huge maximum", "\"maximum\": 0.5", "\"maximum\": 1e30",
        "parameters.melanin.maximum must be positive and at most a million");
    row("absorption", "\"constant\": 0.0244", "\"constant\": -5",
        "absorption must be positive over the whole parameter range");
    row("decay", "\"decay_nm\": 66.2", "\"decay_nm\": 0",
        "absorption.baseline.decay_nm must be positive");
    row("negative decay", "\"decay_nm\": 66.2", "\"decay_nm\": -66.2",
        "absorption.baseline.decay_nm must be positive");
    row("infinite absorption", "\"coefficient\": 6.6e10", "\"coefficient\": 1e308",
        "absorption must be below a million per mm over the whole parameter range, and is not at "
        "300 nm");
    row("optics", "\"diffusion\"", "\"magic\"",
        "layer_optics must be \"diffusion\" or \"adding-doubling\"");
    row("reference", "\"exponent\": -4.75", "\"exponent\": -4.75, \"at_nm\": 0",
        "absorption.pheomelanin.at_nm must be positive");
    row("scattering's reference", "\"exponent\": -0.22", "\"exponent\": -0.22, \"at_nm\": -550",
        "epidermis.mie_scattering.at_nm must be positive");
    row("text for a number", "\"oxygenation\": 0.75", "\"oxygenation\": \"0.75\"",
        "absorption.oxygenation must be a finite number");
    row("prior scale", "\"scale\": \"log\"", "\"scale\": \"cubic\"",
        "prior.scale must be \"linear\" or \"log\"");
    row("no prior", "\"prior\"", "\"description2\"", "unknown field 'description2'");
    row("prior without a mean", "\"mean\": {\"melanin\": 0.05, ", "\"mean\": {",
        "prior.mean.melanin must be a number (it is missing)");
    row("prior at zero", "\"melanin\": 0.05", "\"melanin\": 0",
        "prior.mean.melanin must be positive on the log scale");
    row("prior without spread", "\"carotene\": 0.9}", "\"carotene\": 0}",
        "prior.sd.carotene must be positive");
  }
  void errorsNameFileAndField() { refusesTheChangeOf(paper()); }

  void errorsOfOptionalFieldsToo_data() {
    QTest::addColumn<QString>("from");
    QTest::addColumn<QString>("to");
    QTest::addColumn<QString>("message");
    const auto row = [](const char* from, const char* to, const char* message) {
      QTest::newRow(to) << from << to << message;
    };
    row("\"at_nm\": 500", "\"at\": 500", "unknown field 'absorption.eumelanin.at'");
    row("\"at_nm\": 500", "\"at_nm\": -500", "absorption.eumelanin.at_nm must be positive");
    row("\"blood_smoothing_nm\": 4.25", "\"blood_smoothing_nm\": -1",
        "absorption.blood_smoothing_nm must be between 0 and 100");
    row("\"blood_smoothing_nm\": 4.25", "\"oxygenation\": 0.7",
        "absorption.oxygenation must be left out where both layers have their own");
    row("\"scale\": 3", "\"scale\": -3", "absorption.carotene.scale must be between 0 and 100");
    row("\"scale\": 3", "\"factor\": 3", "unknown field 'absorption.carotene.factor'");
    row("\"shift_nm\": 24", "\"shift_nm\": 124",
        "absorption.carotene.shift_nm must be between -100 and 100");
    row("\"smoothing_nm\": 8", "\"smoothing_nm\": -8",
        "absorption.carotene.smoothing_nm must be between 0 and 100");
    row("\"peak\": 0.012, ", "", "absorption.fat.peak must be a number (it is missing)");
    row("\"peak\": 0.012", "\"peak\": -0.012",
        "absorption.fat.peak must be finite and not negative");
    row("\"deviation_nm\": 22", "\"deviation_nm\": 0",
        "absorption.fat.deviation_nm must be positive");
    row("\"deviation_nm\": 22", "\"deviation_nm\": 22, \"skew\": 1",
        "unknown field 'absorption.fat.skew'");
    row("\"fat\": {", "\"water_band\": {", "unknown field 'absorption.water_band'");
    row("\"fat_fraction\": 0.78", "\"fat_fraction\": 1.78",
        "dermis.fat_fraction must be between 0 and 1");
    row("\"fat_fraction\": 0.78", "\"blood_fraction\": 0.78",
        "unknown field 'dermis.blood_fraction'");
    row("\"oxygenation\": 0.7,", "\"oxygenation\": 1.7,",
        "epidermis.blood.oxygenation must be between 0 and 1");
    row("\"oxygenation\": 0.7,", "", "absorption.oxygenation must be a number (it is missing)");
    row("\"oxygenation\": 0.6,", "\"oxygenation\": -0.6,",
        "dermis.blood.oxygenation must be between 0 and 1");
    row("\"vessel_radius_mm\": 0.004", "\"vessel_radius_mm\": 4",
        "epidermis.blood.vessel_radius_mm must be between 0 and 1");
    row("\"vessel_radius_mm\": 0.016", "\"vessel_radius_mm\": -0.016",
        "dermis.blood.vessel_radius_mm must be between 0 and 1");
    row("\"vessel_radius_mm\": 0.016", "\"vessels\": 0.016",
        "unknown field 'dermis.blood.vessels'");
    row("\"blood\": {\"oxygenation\": 0.6, \"vessel_radius_mm\": 0.016}", "\"blood\": 0.6",
        "dermis.blood must be an object");
    row("\"decay_nm\": 28", "\"decay_nm\": 0", "epidermis.ultraviolet.decay_nm must be positive");
    row("\"amplitude\": 1.66", "\"amplitude\": -166",
        "absorption must be positive over the whole parameter range, and is not at 300 nm");
    row("\"amplitude\": 1.66", "\"amplitude\": \"1.66\"",
        "epidermis.ultraviolet.amplitude must be a finite number");
    row("\"baseline_factor\": 0.48", "\"baseline_factor\": -0.48",
        "dermis.baseline_factor must be between 0 and 10");
    row("\"baseline_factor\": 0.48", "\"scattering_ratio\": 0.5",
        "dermis.scattering_ratio must be left out where the dermis has scattering laws");
    row("\"coefficient\": 2.585", "\"coefficient\": -258.5",
        "dermis.mie_scattering must be such that it scatters 0.001 to 10000 per mm");
    row("\"coefficient\": 2.115", "\"factor\": 2.115",
        "unknown field 'dermis.rayleigh_scattering.factor'");
    row("\"exponent\": -0.71, \"at_nm\": 550", "\"exponent\": -0.71, \"at_nm\": 0",
        "dermis.mie_scattering.at_nm must be positive");
    row("\"refractive_index\": \"The", "\"refraction\": \"The",
        "sources.refraction must be the source of a field of the profile");
    row("\"dermis.fat_fraction\": \"", "\"dermis.fat.fraction\": \"",
        "sources.dermis.fat.fraction must be the source of a field");
    row("\"sources\": {", "\"sources\": {\"name\": 3, ", "sources.name must be a text");
    row("\"sources\": {", "\"sources\": {\"name\": \"\", ",
        "sources.name must be a text that is not empty");
    row("\"linear\": [\"carotene\"]", "\"linear\": [\"bilirubin\"]",
        "prior.linear[0] must be the name of a parameter");
    row("\"linear\": [\"carotene\"]", "\"linear\": \"carotene\"", "prior.linear must be a list");
    row("\"linear\": [\"carotene\"]", "\"linear\": [5]", "prior.linear[0] must be a text");
    row("\"melanin,melanin_blend\": -0.468", "\"melanin,melanin_blend\": -1",
        "prior.correlation.melanin,melanin_blend must be between -1 and 1");
    row("\"melanin,melanin_blend\": -0.468", "\"melanin;melanin_blend\": -0.468",
        "prior.correlation.melanin;melanin_blend must be named by two parameters");
    row("\"melanin,melanin_blend\": -0.468", "\"melanin,melanin\": -0.468",
        "must be named by two parameters");
    row("\"melanin,melanin_blend\": -0.468", "\"carotene,melanin\": -0.468", "must be given once");
    row("\"melanin,carotene\": -0.435", "\"melanin,carotene\": -0.99",
        "prior.correlation must be positive definite");
  }
  void errorsOfOptionalFieldsToo() { refusesTheChangeOf(measured()); }

  // A table of skin must fit into memory.
  void tablesHaveALimit() {
    const QRegularExpression samples("\"samples\": [0-9]+");
    const auto withSamples = [&](int count) {
      const QString text = QString::fromStdString(paper());
      const QString field = QString("\"samples\": %1").arg(count);
      return parseProfile(QString(text).replace(samples, field).toStdString(), "p.json");
    };
    EXPECT_OK(withSamples(25));  // 25⁵ = 9.8 million
    EXPECT_ERROR(withSamples(26),
                 "the product of all parameters.*.samples must be at most 10 million");
    EXPECT_ERROR(withSamples(256), "the product of all parameters.*.samples");
  }

  void fingerprintsTellModelsApart() {
    const std::string original = fingerprint(test::li2024().profile());
    const auto of = [&](const char* from, const char* to) {
      const auto profile = parseProfile(changedProfile(paper(), from, to), "p.json");
      return profile ? fingerprint(profile.value()) : profile.error().text();
    };
    QVERIFY(of("\"thickness_mm\": 0.32", "\"thickness_mm\": 0.33") != original);
    QVERIFY(of("\"samples\": 51", "\"samples\": 50") != original);
    QVERIFY(of("\"oxygenation\": 0.75", "\"oxygenation\": 0.7501") != original);
    QVERIFY(of("\"exponent\": -4}", "\"exponent\": -4.001}") != original);
    // The prior and the names change no reflectance.
    QCOMPARE(of("\"melanin\": 0.05", "\"melanin\": 0.06"), original);
    QCOMPARE(of("\"name\": \"li2024\"", "\"name\": \"other\""), original);
  }

  void signaturesForgiveRoundingAlone() {
    const Profile& original = test::li2024().profile();
    const auto is = [&](const Profile& other) {
      return alike(signatureOf(other), signatureOf(original));
    };
    Profile rounded = original;
    rounded.eumelanin.coefficient *= 1.0 + 1e-15;
    rounded.oxyhaemoglobin *= 1.0 - 1e-15;
    rounded.prior = {};
    QVERIFY(fingerprint(rounded) != fingerprint(original));
    QVERIFY(is(rounded));
    Profile other = original;
    other.dermalBlood.oxygenation += 1e-4;
    QVERIFY(!is(other));
    other = original;
    other.carotene[80] *= 1.01;
    QVERIFY(!is(other));
    // Fields that the paper's model does not have, of one value.
    Profile dermal = original, epidermal = original;
    dermal.dermalBlood.vesselRadiusMm = epidermal.epidermalBlood.vesselRadiusMm = 0.01;
    QVERIFY(!is(dermal) && !is(epidermal));
    QVERIFY(!alike(signatureOf(dermal), signatureOf(epidermal)));
  }

 private:
  // The row's change.
  static void refusesTheChangeOf(const std::string& text) {
    QFETCH(QString, from);
    QFETCH(QString, to);
    QFETCH(QString, message);
    const auto profile =
        parseProfile(changedProfile(text, from.toStdString(), to.toStdString()), "p.json");
    QVERIFY(profile.failed());
    QVERIFY2(profile.error().text().find(message.toStdString()) != std::string::npos,
             profile.error().text().c_str());
    QVERIFY2(profile.error().text().starts_with("p.json: "), profile.error().text().c_str());
  }
};

CUTIS_TEST(ProfileFileTest)

}  // namespace
}  // namespace cutis

#include "profile_file_test.moc"
