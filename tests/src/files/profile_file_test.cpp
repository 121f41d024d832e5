#include <QRegularExpression>
#include <QtTest>

#include "src/files/profile_file.h"
#include "src/files/resources.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

std::string paper() { return std::string(*resource("profiles/li2024.json")); }

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const auto at = text.find(from);
  if (at == std::string::npos) return "test is wrong: " + from;
  return text.replace(at, from.size(), to);
}

class ProfileFileTest : public QObject {
  Q_OBJECT

 private slots:
  // MODEL.md, parameters and constants.
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
    EXPECT_NEAR(profile.oxygenation, 0.75, 0.0);
    EXPECT_NEAR(profile.epidermalThicknessMm, 0.32, 0.0);
    EXPECT_NEAR(profile.refractiveIndex, 1.4, 0.0);
    EXPECT_NEAR(profile.dermalScatteringRatio, 0.5, 0.0);
    QVERIFY(profile.prior.scale == PriorScale::log);
  }

  void namesAndFilesGiveTheSameModel() {
    QVERIFY(profileNames() == std::vector<std::string>{"li2024"});
    const test::ScratchFolder folder;
    const auto path = folder.write("copy.json", paper());
    const auto copy = loadProfile(path.string(), "--profile");
    EXPECT_OK(copy);
    QCOMPARE(fingerprint(copy.value()), fingerprint(test::li2024().profile()));
    QVERIFY(profileText("li2024", "t").value() == paper());
    QVERIFY(profileText(path.string(), "t").value() == paper());
  }

  void unknownNamesSuggest() {
    EXPECT_ERROR(loadProfile("li2042", "--profile"),
                 "--profile: unknown profile 'li2042'; did you mean 'li2024'?");
    EXPECT_ERROR(loadProfile("gone.json", "--profile"), "gone.json: there is no such file");
  }

  void chromophoresLieBesideTheFile() {
    const test::ScratchFolder folder;
    folder.write("sub/p.json", changed(paper(), "\"chromophores\": \"chromophores\"",
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
    row("another kind", "\"cutis_profile\": 1", "\"cutis_rig\": 1", "\"cutis_profile\": 1 is missing");
    row("unknown field", "\"dermis\"", "\"Dermis\"", "unknown field 'Dermis'");
    row("no maximum", "\"maximum\": 0.5, ", "", "parameters.melanin.maximum must be a number");
    row("negative maximum", "\"maximum\": 0.5", "\"maximum\": -0.5", "parameters.melanin.maximum must be positive");
    row("one sample", "\"samples\": 51", "\"samples\": 1", "parameters.melanin.samples must be between 2 and 256");
    row("half a sample", "\"samples\": 51", "\"samples\": 51.5", "parameters.melanin.samples must be a whole number");
    row("too many samples", "\"samples\": 51", "\"samples\": 257", "between 2 and 256");
    row("spacing", "\"cubic\"", "\"quartic\"", "parameters.melanin.spacing must be \"uniform\", \"quadratic\" or \"cubic\"");
    row("extra parameter", "\"parameters\": {", "\"parameters\": {\"bilirubin\": {}, ", "unknown field 'parameters.bilirubin'");
    row("oxygenation", "\"oxygenation\": 0.75", "\"oxygenation\": 1.01", "absorption.oxygenation must be between 0 and 1");
    row("water", "\"water_fraction\": 0.2", "\"water_fraction\": -0.2", "epidermis.water_fraction must be between 0 and 1");
    row("dermal water", "\"water_fraction\": 0.6", "\"water_fraction\": 1.6", "dermis.water_fraction must be between 0 and 1");
    row("index", "\"refractive_index\": 1.4", "\"refractive_index\": 0.9", "refractive_index must be between 1 and 2");
    row("ratio", "\"scattering_ratio\": 0.5", "\"scattering_ratio\": 0", "dermis.scattering_ratio must be positive");
    row("thin", "\"thickness_mm\": 0.32", "\"thickness_mm\": 0.1", "epidermis.thickness_mm must be at least");
    row("no thickness", "\"thickness_mm\": 0.32", "\"thickness_mm\": 0", "epidermis.thickness_mm must be between 0 and 10");
    row("scattering", "\"coefficient\": 14.74", "\"coefficient\": -1e6", "epidermis.reduced_scattering must be positive");
    row("absorption", "\"constant\": 0.0244", "\"constant\": -5", "absorption must be positive over the whole parameter range");
    row("decay", "\"decay_nm\": 66.2", "\"decay_nm\": 0", "absorption.baseline.decay_nm must be positive");
    row("negative decay", "\"decay_nm\": 66.2", "\"decay_nm\": -66.2", "absorption.baseline.decay_nm must be positive");
    row("infinite absorption", "\"coefficient\": 6.6e10", "\"coefficient\": 1e308", "absorption must be below a million per mm over the whole parameter range, and is not at 300 nm");
    row("optics", "\"diffusion\"", "\"magic\"", "layer_optics must be \"diffusion\"");
    row("text for a number", "\"oxygenation\": 0.75", "\"oxygenation\": \"0.75\"", "absorption.oxygenation must be a finite number");
    row("prior scale", "\"scale\": \"log\"", "\"scale\": \"cubic\"", "prior.scale must be \"linear\" or \"log\"");
    row("no prior", "\"prior\"", "\"description2\"", "unknown field 'description2'");
    row("prior without a mean", "\"mean\": {\"melanin\": 0.05, ", "\"mean\": {", "prior.mean.melanin must be a number (it is missing)");
    row("prior at zero", "\"melanin\": 0.05", "\"melanin\": 0", "prior.mean.melanin must be positive on the log scale");
    row("prior without spread", "\"carotene\": 0.9}", "\"carotene\": 0}", "prior.sd.carotene must be positive");
  }
  void errorsNameFileAndField() {
    QFETCH(QString, from);
    QFETCH(QString, to);
    QFETCH(QString, message);
    const auto profile =
        parseProfile(changed(paper(), from.toStdString(), to.toStdString()), "p.json");
    QVERIFY(profile.failed());
    QVERIFY2(profile.error().text().find(message.toStdString()) != std::string::npos,
             profile.error().text().c_str());
    QVERIFY2(profile.error().text().starts_with("p.json: "), profile.error().text().c_str());
  }

  // A table of skin must fit into memory.
  void tablesHaveALimit() {
    const QRegularExpression samples("\"samples\": [0-9]+");
    const auto withSamples = [&](int count) {
      const QString text = QString::fromStdString(paper());
      const QString field = QString("\"samples\": %1").arg(count);
      return parseProfile(QString(text).replace(samples, field).toStdString(), "p.json");
    };
    EXPECT_OK(withSamples(25));  // 25⁵ = 9.8 million
    EXPECT_ERROR(withSamples(26), "the product of all parameters.*.samples must be at most 10 million");
    EXPECT_ERROR(withSamples(256), "the product of all parameters.*.samples");
  }

  void fingerprintsTellModelsApart() {
    const std::string original = fingerprint(test::li2024().profile());
    const auto of = [&](const char* from, const char* to) {
      const auto profile = parseProfile(changed(paper(), from, to), "p.json");
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
};

class PriorFileTest : public QObject {
  Q_OBJECT

 private slots:
  // INTERFACES.md, PRIOR.json: {"scale": "linear"|"log", "mean": {NAME: x}, "sd": {NAME: x}}.
  void whatIsLeftOutStays() {
    const Prior& base = test::li2024().profile().prior;
    const auto prior = read(R"({"scale": "log", "mean": {"melanin": 0.2}, "sd": {"carotene": 0.1}})");
    EXPECT_OK(prior);
    for (const Parameter parameter : kParameters) {
      EXPECT_NEAR(prior.value().mean[parameter],
                  parameter == kMelanin ? 0.2 : base.mean[parameter], 0.0);
      EXPECT_NEAR(prior.value().deviation[parameter],
                  parameter == kCarotene ? 0.1 : base.deviation[parameter], 0.0);
    }
    QVERIFY(prior.value().scale == PriorScale::log);
    EXPECT_OK(read(R"({"scale": "log"})"));
  }

  // Numbers of one scale mean nothing on the other.
  void anotherScaleMustBeComplete() {
    EXPECT_ERROR(read(R"({"scale": "linear", "mean": {"melanin": 0.2}})"),
                 "mean.melanin_blend must be a number (it is missing)");
    const auto linear = read(
        R"({"scale": "linear",
            "mean": {"melanin": 0, "melanin_blend": 0.5, "haemoglobin_dermal": 0.02,
                     "haemoglobin_epidermal": 0.01, "carotene": 0},
            "sd": {"melanin": 0.1, "melanin_blend": 0.5, "haemoglobin_dermal": 0.02,
                   "haemoglobin_epidermal": 0.01, "carotene": 0.001}})");
    EXPECT_OK(linear);
    QVERIFY(linear.value().scale == PriorScale::linear);
    QVERIFY(!linear.value().isLog(kMelanin));
    EXPECT_NEAR(linear.value().deviation[kCarotene], 0.001, 0.0);
  }

  void errorsNameTheField() {
    EXPECT_ERROR(read(R"({"scale": "log", "mean": {"melanine": 1}})"), "unknown field 'mean.melanine'");
    EXPECT_ERROR(read(R"({"scale": "log", "means": {}})"), "unknown field 'means'");
    EXPECT_ERROR(read(R"({"scale": 3})"), "scale must be a text");
    EXPECT_ERROR(read(R"({"scale": "log", "sd": {"melanin": -1}})"), "sd.melanin must be positive");
    EXPECT_ERROR(read(R"({"scale": "log", "mean": {"melanin": 0}})"),
                 "mean.melanin must be positive on the log scale");
    EXPECT_ERROR(read(R"({"scale": "log", "mean": {"melanin": "much"}})"),
                 "mean.melanin must be a finite number");
    EXPECT_ERROR(read(R"({"scale": "log", "mean": 5})"), "mean must be an object");
    EXPECT_ERROR(read("{]"), "prior.json:1:2: not valid JSON");
    EXPECT_ERROR(readPrior("gone.json", test::li2024().profile().prior), "there is no such file");
  }

 private:
  static Result<Prior> read(const char* text) {
    const test::ScratchFolder folder;
    return readPrior(folder.write("prior.json", text).string(), test::li2024().profile().prior);
  }
};

CUTIS_TEST(ProfileFileTest)
CUTIS_TEST(PriorFileTest)

}  // namespace
}  // namespace cutis

#include "profile_file_test.moc"
