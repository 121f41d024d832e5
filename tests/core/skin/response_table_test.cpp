// The table of a response against the model that it is made of, and against simplex interpolation
// written out once more.

#include "core/skin/response_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <vector>

#include <QtTest>

#include "core/skin/model/reflectance_batch.h"
#include "core/skin/profile/parameter_sampling.h"
#include "core/spectra/colorimetry.h"
#include "src/files/profiles/profile_file.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
// Its own, since tests of a folder are compiled together.
namespace response_table {
namespace {

using Channels = std::array<std::vector<float>, 3>;

const SkinModel& twoLayers() {
  static const auto made = SkinModel::create(loadProfile("skin2026", "test").value()).value();
  return *made;
}

ResponseModel daylight(const SkinModel& model) {
  return ResponseModel(model, tristimulusRows(test::light("D65"), test::cie1931()));
}

template <typename Response>
Channels evaluate(const Response& response, PixelRows<const float> values) {
  Channels channels;
  std::vector<float*> out;
  for (auto& channel : channels) {
    channel.resize(values.count);
    out.push_back(channel.data());
  }
  response.evaluate(values, out);
  return channels;
}

Eigen::Vector3d lab(const Channels& channels, std::size_t i) {
  static const Eigen::Vector3d white = test::daylightWhite();
  return labFromXyz({channels[0][i], channels[1][i], channels[2][i]}, white);
}

// Where a value lies on an axis, split; the last interval holds its end.
struct Place {
  int below;
  double fraction;
};

Place placeOn(const ParameterAxis& axis, double value) {
  const double index = axis.index(value);
  const int below = std::min(static_cast<int>(index), axis.samples - 2);
  return {below, index - below};
}

// From corner to corner of the simplex, the parameter with the largest fraction first.
double interpolated(const ResponseModel& response, const ParameterAxes& axes,
                    const ParameterVector& point) {
  std::array<Place, kParameterCount> places;
  std::array<std::size_t, kParameterCount> order = {0, 1, 2, 3, 4};
  for (std::size_t k = 0; k < kParameterCount; ++k)
    places[k] = placeOn(axes[k], point[static_cast<Eigen::Index>(k)]);
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return places[a].fraction > places[b].fraction; });
  const auto logarithmAt = [&](const std::array<int, kParameterCount>& corner) -> double {
    ParameterVector at;
    for (std::size_t k = 0; k < kParameterCount; ++k)
      at[static_cast<Eigen::Index>(k)] = axes[k].value(corner[k]);
    return std::log(evaluate(response, parameterRows<float>(std::vector{at}).rows())[1][0]);
  };
  std::array<int, kParameterCount> corner;
  for (std::size_t k = 0; k < kParameterCount; ++k)
    corner[k] = places[k].below;
  double value = logarithmAt(corner);
  double before = value;
  for (const std::size_t k : order) {
    ++corner[k];
    const double next = logarithmAt(corner);
    value += places[k].fraction * (next - before);
    before = next;
  }
  return std::exp(value);
}

class ResponseTableTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { QVERIFY(twoLayers().profile().axes[0].maximum > 0.0); }

  void coloursAreWithinTheStatedError() {
    for (const SkinModel* model : {&test::li2024(), &twoLayers()}) {
      const ResponseModel response = daylight(*model);
      const ResponseTable table(response, model->profile().axes);
      const auto points = sampleBox(model->profile().axes, 40000);
      const PixelBuffer<float> values = parameterRows<float>(points);
      const Channels exact = evaluate(response, values.rows());
      const Channels quick = evaluate(table, values.rows());
      double worst = 0.0, sum = 0.0;
      for (std::size_t i = 0; i < points.size(); ++i) {
        const double error = deltaE2000(lab(exact, i), lab(quick, i));
        worst = std::max(worst, error);
        sum += error;
      }
      EXPECT_AT_MOST(worst, 0.3);
      EXPECT_AT_MOST(sum / static_cast<double>(points.size()), 0.06);
    }
  }

  void itInterpolatesBetweenTheCornersOfASimplex() {
    const SkinModel& model = test::li2024();
    const ResponseModel response = daylight(model);
    const ResponseTable table(response, model.profile().axes);
    const ParameterAxes axes = responseTableAxes(model.profile().axes);
    const auto points = sampleBox(model.profile().axes, 200, 77);
    const Channels quick = evaluate(table, parameterRows<float>(points).rows());
    for (std::size_t i = 0; i < points.size(); ++i)
      EXPECT_NEAR(double{quick[1][i]}, interpolated(response, axes, points[i]), 2e-5);
  }

  // Corners of the box, values beyond it, and counts that fill no vector.
  void theEndsOfTheRangesAreTheirs() {
    const SkinModel& model = test::li2024();
    const ResponseModel response = daylight(model);
    const ResponseTable table(response, model.profile().axes);
    std::vector<ParameterVector> corners;
    for (int corner = 0; corner < 32; ++corner) {
      ParameterVector p;
      for (int k = 0; k < kParameterCount; ++k)
        p[k] = (corner >> k & 1) * model.profile().axes[static_cast<std::size_t>(k)].maximum;
      corners.push_back(p);
    }
    auto beyond = corners;
    for (ParameterVector& p : beyond)
      p = 3.0 * p - 1e-3;
    corners.pop_back();
    beyond.pop_back();
    const Channels exact = evaluate(response, parameterRows<float>(corners).rows());
    const Channels atEnd = evaluate(table, parameterRows<float>(corners).rows());
    const Channels outside = evaluate(table, parameterRows<float>(beyond).rows());
    for (std::size_t i = 0; i < corners.size(); ++i) {
      EXPECT_NEAR(double{atEnd[1][i]}, double{exact[1][i]}, 1e-6);
      EXPECT_NEAR(double{outside[1][i]}, double{exact[1][i]}, 1e-6);
    }
  }
};

CUTIS_TEST(ResponseTableTest);

}  // namespace
}  // namespace response_table
}  // namespace cutis

#include "response_table_test.moc"
