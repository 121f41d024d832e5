// The difference of two pictures against the formula in double precision.

#include "core/render/color_difference.h"

#include <cmath>
#include <limits>

#include <QtTest>

#include "core/base/random.h"
#include "core/spectra/colorimetry.h"
#include "core/spectra/rgb_primaries.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr double kBound = 0.005;  // or, of large differences, a share
constexpr double kBoundShare = 0.001;

PictureBuffer pictureOf(const std::vector<Eigen::Vector3d>& colors) {
  PictureBuffer picture;
  picture.width = static_cast<int>(colors.size());
  picture.height = 1;
  picture.present.assign(colors.size(), true);
  picture.channels.resize(3);
  for (const Eigen::Vector3d& color : colors) {
    for (int c = 0; c < 3; ++c)
      picture.channels[static_cast<std::size_t>(c)].push_back(static_cast<float>(color[c]));
  }
  return picture;
}

double exactly(const PictureBuffer& a, const PictureBuffer& b, std::size_t i) {
  const Eigen::Vector3d white = kRec709.xyzOfWhite();
  const auto lab = [&](const PictureBuffer& picture) {
    const auto& c = picture.channels;
    const Eigen::Vector3d rgb(c[0][i], c[1][i], c[2][i]);
    return labFromXyz(xyzFromRec709(white) * rgb, white);
  };
  return deltaE2000(lab(a), lab(b));
}

Eigen::Vector3d randomColor(Random& random, double from, double to) {
  Eigen::Vector3d color;
  for (double& part : color)
    part = from + (to - from) * random.uniform();
  return color;
}

class ColorDifferenceTest : public QObject {
  Q_OBJECT

 private slots:
  void isTheFormula_data() {
    QTest::addColumn<double>("from");
    QTest::addColumn<double>("to");
    QTest::addColumn<double>("apart");  // how far the second colour may be; 0: anywhere
    QTest::newRow("any two colours") << 0.0 << 1.0 << 0.0;
    QTest::newRow("neighbours") << 0.0 << 1.0 << 0.01;
    QTest::newRow("almost the same") << 0.0 << 1.0 << 1e-4;
    QTest::newRow("dark") << 0.0 << 0.01 << 0.0;
    QTest::newRow("beyond the range of a screen") << -0.2 << 4.0 << 0.0;
  }
  void isTheFormula() {
    QFETCH(double, from);
    QFETCH(double, to);
    QFETCH(double, apart);
    Random random(7);
    std::vector<Eigen::Vector3d> first, second;
    for (int i = 0; i < 50021; ++i) {
      first.push_back(randomColor(random, from, to));
      second.push_back(apart > 0 ? first.back() + randomColor(random, -apart, apart)
                                 : randomColor(random, from, to));
    }
    compare(pictureOf(first), pictureOf(second));
  }

  // Where hue means nothing, or its angle runs through 0, or the formula turns the ellipses.
  void specialColors() {
    std::vector<Eigen::Vector3d> colors = {{0, 0, 0},       {1, 1, 1},        {0.2, 0.2, 0.2},
                                           {0.02, 0.02, 1}, {0.1, 0.05, 0.9}, {0.6, 0.1, 0.3},
                                           {0.6, 0.1, 0.2}, {0.7, 0.4, 0.3},  {0, 1, 0}};
    std::vector<Eigen::Vector3d> first, second;
    for (const auto& a : colors) {
      for (const auto& b : colors) {
        first.push_back(a);
        second.push_back(b);
      }
    }
    compare(pictureOf(first), pictureOf(second));
  }

  void whatIsMissingStaysMissing() {
    PictureBuffer a = pictureOf({{0.5, 0.4, 0.3}, {0.5, 0.4, 0.3}, {0.5, 0.4, 0.3}});
    PictureBuffer b = a;
    a.present[0] = false;
    b.channels[1][1] = std::numeric_limits<float>::quiet_NaN();
    const auto difference = colorDifference(a, b, {});
    QVERIFY(!difference.value().present[0] && difference.value().present[2]);
    QVERIFY(std::isnan(difference.value().channels[0][1]));
    QCOMPARE(difference.value().channels[0][2], 0.0f);
  }

  void mapsDifferByTheirValues() {
    PictureBuffer a = pictureOf({{0.5, 0, 0}, {0.1, 0, 0}});
    const PictureBuffer b = pictureOf({{0.2, 0, 0}, {0.4, 0, 0}});
    a.present[1] = false;
    const PictureBuffer difference = absoluteDifference(a, b);
    EXPECT_NEAR(double{difference.channels[0][0]}, 0.3, 1e-6);
    QVERIFY(difference.present[0] && !difference.present[1]);
  }

 private:
  static void compare(const PictureBuffer& a, const PictureBuffer& b) {
    const auto difference = colorDifference(a, b, {});
    QVERIFY(difference);
    double worst = 0;
    for (std::size_t i = 0; i < a.present.size(); ++i) {
      const double exact = exactly(a, b, i);
      const double off = std::abs(double{difference.value().channels[0][i]} - exact) /
                         std::max(kBound, kBoundShare * exact);
      if (!(off <= worst)) worst = off;
    }
    QVERIFY2(worst <= 1.0, qPrintable(QString("off by %1 bounds").arg(worst)));
  }
};

CUTIS_TEST(ColorDifferenceTest)

}  // namespace
}  // namespace cutis

#include "color_difference_test.moc"
