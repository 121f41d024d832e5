// Drafts for a moving control against the pictures that they stand for.

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <QtTest>

#include "core/base/random.h"
#include "core/maths/quantile.h"
#include "core/render/relight.h"
#include "core/render/skin_samples.h"
#include "core/skin/profile/parameter_names.h"
#include "core/skin/profile/parameter_sampling.h"
#include "src/files/profiles/profile_file.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
// Its own, since tests of a folder are compiled together.
namespace draft_samples {
namespace {

constexpr int kWidth = 150;
constexpr int kHeight = 100;

std::shared_ptr<const SkinModel> model() {
  static const auto made = SkinModel::create(loadProfile("skin2026b", "test").value()).value();
  return made;
}

const Discrepancy& discrepancy() {
  return *model()->profile().discrepancies.of(SurfaceLight::included);
}

const ParameterAxes& axes() {
  return model()->profile().axes;
}

const ResponseModel& daylight() {
  static const ResponseModel response(
      *model(),
      colourRows(test::light("D65"), test::cie1931(), ChromaticAdaptation::none, test::light("D65"),
                 test::cie1931()),
      {}, &discrepancy());
  return response;
}

const ResponseTable& table() {
  static const ResponseTable made(daylight(), axes());
  return made;
}

// People over the whole box, each with this share of a discrepancy drawn for it; every seventh
// pixel has no estimate.
SkinSamples people(double share) {
  const auto points = sampleBox(axes(), kWidth * kHeight);
  SkinSamples samples;
  ParameterBuffer people;
  samples.rect = {0, 0, kWidth, kHeight};
  people.values = PixelBuffer<float>(
      static_cast<std::size_t>(kParameterCount + discrepancy().count()), points.size());
  Random random(5);
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int k = 0; k < kParameterCount; ++k)
      people.values[static_cast<std::size_t>(k)][i] = static_cast<float>(points[i][k]);
    for (int c = 0; c < discrepancy().count(); ++c) {
      const double deviation = std::sqrt(discrepancy().covariance(c, c));
      people.values[static_cast<std::size_t>(kParameterCount + c)][i] =
          static_cast<float>(share * deviation * random.normal());
    }
    people.present.push_back(i % 7 != 3);
  }
  samples.original = responseTo(people, daylight());
  samples.tabulated = responseTo(people, table());
  samples.parameters = std::make_shared<const ParameterBuffer>(std::move(people));
  return samples;
}

Eigen::Vector3d lab(const PictureBuffer& picture, std::size_t i) {
  static const Eigen::Vector3d white = test::daylightWhite();
  static const Eigen::Matrix3d toXyz = xyzFromRec709(white);
  const Eigen::Vector3d rgb(picture.channels[0][i], picture.channels[1][i], picture.channels[2][i]);
  return labFromXyz(toXyz * rgb, white);
}

// The errors of the drafts of all people with an estimate, CIEDE2000.
std::vector<double> errorsOf(const EditStack& edits, double discrepancyShare) {
  const SkinSamples samples = people(discrepancyShare);
  const auto exact = renderSamples(samples, edits, axes(), daylight());
  const auto unedited = renderSamples(samples, {}, axes(), daylight());
  std::vector<double> errors;
  if (!exact || !unedited) return errors;
  const auto draft = draftSamples(unedited.value(), samples, edits, axes(), table());
  if (!draft) return errors;
  for (std::size_t i = 0; i < samples.parameters->count(); ++i) {
    if (samples.parameters->present[i])
      errors.push_back(deltaE2000(lab(exact.value(), i), lab(draft.value(), i)));
  }
  return errors;
}

class DraftSamplesTest : public QObject {
  Q_OBJECT

 private slots:
  void draftsAreWithinTheStatedErrorOfThePicture_data() {
    QTest::addColumn<int>("parameter");
    QTest::addColumn<double>("scale");
    for (const double scale : {0.0, 0.5, 1.1, 2.0, 4.0}) {
      for (int k = 0; k < kParameterCount; ++k)
        QTest::addRow("%s x%g", std::string(parameterNames()[static_cast<std::size_t>(k)]).c_str(),
                      scale)
            << k << scale;
    }
  }
  void draftsAreWithinTheStatedErrorOfThePicture() {
    QFETCH(int, parameter);
    QFETCH(double, scale);
    EditStack edits(1);
    edits[0].parameters[static_cast<std::size_t>(parameter)].scale = scale;
    std::vector<double> plain = errorsOf(edits, 0.0);
    std::vector<double> withDiscrepancy = errorsOf(edits, 1.0);
    QVERIFY(!plain.empty() && !withDiscrepancy.empty());
    EXPECT_AT_MOST(quantileOf(plain, 0.99), scale > 0.0 ? 0.15 : 0.25);
    EXPECT_AT_MOST(quantileOf(plain, 1.0), scale > 0.0 ? 0.3 : 0.4);
    EXPECT_AT_MOST(quantileOf(withDiscrepancy, 0.99), scale > 0.0 ? 0.2 : 0.5);
    EXPECT_AT_MOST(quantileOf(withDiscrepancy, 1.0), scale > 0.0 ? 0.5 : 1.5);
  }

  // What edits leave alone is what it was, to the last bit, and so is what is no skin.
  void whatIsNotEditedStaysAsItIs() {
    const SkinSamples samples = people(1.0);
    PictureBuffer grey;
    grey.width = kWidth;
    grey.height = kHeight;
    grey.channels.assign(3, std::vector<float>(samples.parameters->count(), 0.3f));
    grey.present.assign(samples.parameters->count(), true);
    EditStack edits(1);
    edits[0].parameters[kMelanin].scale = 2.0;
    edits[0].mask = Plane(kWidth, kHeight);
    EXPECT_OK(edits[0].mask.store({0, 0, 1, 1}, std::vector{1.0f}));
    const auto draft = draftSamples(grey, samples, edits, axes(), table());
    EXPECT_OK(draft);
    QVERIFY(draft.value().channels[1][0] < 0.3f);
    for (std::size_t i = 1; i < samples.parameters->count(); ++i)
      QCOMPARE(draft.value().channels[1][i], 0.3f);
  }
};

CUTIS_TEST(DraftSamplesTest);

}  // namespace
}  // namespace draft_samples
}  // namespace cutis

#include "draft_samples_test.moc"
