#include "src/files/profiles/prior_file.h"

#include <QtTest>

#include "src/files/profiles/profile_file.h"
#include "tests/support/expect.h"
#include "tests/support/folders.h"
#include "tests/support/models.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

// One with a linear carotene and correlations.
Prior twoLayers() {
  return loadProfile(test::sourceFolder() / "tests/support/two_layer_profile.json", "test")
      .value()
      .prior;
}

class PriorFileTest : public QObject {
  Q_OBJECT

 private slots:
  // resources/manual/file_formats.md, prior: {"scale": "linear"|"log", "mean": {NAME: x},
  // "sd": {NAME: x}}.
  void whatIsLeftOutStays() {
    const Prior& base = test::li2024().profile().prior;
    const auto prior =
        read(R"({"scale": "log", "mean": {"melanin": 0.2}, "sd": {"carotene": 0.1}})");
    EXPECT_OK(prior);
    for (const Parameter parameter : kParameters) {
      EXPECT_NEAR(prior.value().mean[parameter], parameter == kMelanin ? 0.2 : base.mean[parameter],
                  0.0);
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

  // The scale is "log" but for the parameters that "linear" names.
  void scalesMayBeMixed() {
    const auto mixed = read(
        R"({"scale": "log", "linear": ["carotene"],
            "mean": {"carotene": 0}, "sd": {"carotene": 0.003}})");
    EXPECT_OK(mixed);
    QVERIFY(!mixed.value().isLog(kCarotene) && !mixed.value().isLog(kMelaninBlend));
    QVERIFY(mixed.value().isLog(kMelanin));
    EXPECT_NEAR(mixed.value().mean[kCarotene], 0.0, 0.0);
    // Numbers of a logarithm mean nothing to the parameter itself, nor the reverse.
    EXPECT_ERROR(read(R"({"scale": "log", "linear": ["carotene"]})"), "mean must be an object");
    EXPECT_ERROR(read(R"({"scale": "log", "linear": ["carotene"], "mean": {"carotene": 0.002}})"),
                 "sd must be an object");
    const Prior measuredPrior = twoLayers();
    EXPECT_ERROR(read(R"({"scale": "log", "mean": {"carotene": 0.002}})", measuredPrior),
                 "sd must be an object");
    const auto log = read(
        R"({"scale": "log", "mean": {"carotene": 0.002}, "sd": {"carotene": 0.9}})", measuredPrior);
    EXPECT_OK(log);
    QVERIFY(log.value().isLog(kCarotene));
    // Whoever is not named stays, scale and correlations included.
    const auto other = read(R"({"scale": "log", "mean": {"melanin": 0.1}})", measuredPrior);
    EXPECT_OK(other);
    QVERIFY(!other.value().isLog(kCarotene));
    QVERIFY(other.value().correlation == measuredPrior.correlation);
    EXPECT_NEAR(log.value().correlation(kCarotene, kMelanin), 0.0, 0.0);
    EXPECT_NEAR(log.value().correlation(kMelanin, kMelaninBlend), -0.468, 0.0);
  }

  void correlationsAreOfPairs() {
    QVERIFY(read(R"({"scale": "log"})").value().correlation.isIdentity(0.0));
    const auto prior = read(
        R"({"scale": "log", "correlation": {"carotene,melanin": -0.3, "melanin,melanin_blend": 0.5}})");
    EXPECT_OK(prior);
    ParameterMatrix expected = ParameterMatrix::Identity();
    expected(0, 4) = expected(4, 0) = -0.3;
    expected(0, 1) = expected(1, 0) = 0.5;
    QVERIFY(prior.value().correlation == expected);
    const auto none = read(R"({"scale": "log", "correlation": {}})", twoLayers());
    EXPECT_OK(none);
    QVERIFY(none.value().correlation.isIdentity(0.0));
    EXPECT_ERROR(
        read(R"({"scale": "log", "correlation": {"carotene": 0.1}})"),
        "correlation.carotene must be named by two parameters, as in \"melanin,melanin_blend\"");
    EXPECT_ERROR(read(R"({"scale": "log", "correlation": {"carotene,melanin": "much"}})"),
                 "correlation.carotene,melanin must be a finite number");
    EXPECT_ERROR(read(R"({"scale": "log", "correlation": 0.5})"), "correlation must be an object");
    EXPECT_ERROR(read(R"({"scale": "log", "correlation": {"melanin,melanin_blend": 0.9,
                          "melanin,carotene": 0.9, "melanin_blend,carotene": -0.9}})"),
                 "correlation must be positive definite");
  }

  void errorsNameTheField() {
    EXPECT_ERROR(read(R"({"scale": "log", "mean": {"melanine": 1}})"),
                 "unknown field 'mean.melanine'");
    EXPECT_ERROR(read(R"({"scale": "log", "means": {}})"), "unknown field 'means'");
    EXPECT_ERROR(read(R"({"scale": 3})"), "scale must be a text");
    EXPECT_ERROR(read(R"({"scale": "log", "sd": {"melanin": -1}})"), "sd.melanin must be positive");
    EXPECT_ERROR(read(R"({"scale": "log", "mean": {"melanin": 0}})"),
                 "mean.melanin must be positive on the log scale");
    EXPECT_ERROR(read(R"({"scale": "log", "mean": {"melanin": "much"}})"),
                 "mean.melanin must be a finite number");
    EXPECT_ERROR(read(R"({"scale": "log", "mean": 5})"), "mean must be an object");
    EXPECT_ERROR(read(R"({"scale": "log", "sd": {"melanin": 1e-300}})"), "from 1e-12 to 1e12");
    EXPECT_ERROR(read(R"({"scale": "log", "mean": {"melanin": 1e300}})"), "at most 1e12");
    EXPECT_ERROR(read("{]"), "prior.json:1:2: not valid JSON");
    EXPECT_ERROR(readPrior("gone.json", test::li2024().profile().prior), "there is no such file");
  }

 private:
  static Result<Prior> read(const char* text, const Prior& base = test::li2024().profile().prior) {
    const test::ScratchFolder folder;
    return readPrior(folder.write("prior.json", text).string(), base);
  }
};

CUTIS_TEST(PriorFileTest)

}  // namespace
}  // namespace cutis

#include "prior_file_test.moc"
