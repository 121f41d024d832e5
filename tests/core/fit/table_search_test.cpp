#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include <Eigen/QR>
#include <QtTest>

#include "core/base/random.h"
#include "core/fit/population.h"
#include "core/fit/table/search_solver.h"
#include "tests/core/fit/fit_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr int kPixels = 200;

// The methods full-search and three-stage of resources/manual/fitting.md, in double precision and
// without a thought for speed.
class NaiveSearch {
 public:
  // The table's rows: r, g, b under white, sb, sg, X, Y, Z under D65.
  explicit NaiveSearch(const SkinTable& table) : table_(table), white_(test::daylightWhite()) {
    const auto size = static_cast<Eigen::Index>(table.size());
    Eigen::MatrixXd rgb(size, 3), xyz(size, 3);
    for (int c = 0; c < 3; ++c) {
      for (Eigen::Index i = 0; i < size; ++i) {
        rgb(i, c) = double{table.channel(c)[static_cast<std::size_t>(i)]};
        xyz(i, c) = double{table.channel(5 + c)[static_cast<std::size_t>(i)]};
      }
    }
    toXyz_ = rgb.colPivHouseholderQr().solve(xyz).transpose();
    for (Eigen::Index i = 0; i < size; ++i) {
      const auto at = static_cast<std::size_t>(i);
      entries_.push_back(featuresOf(rgb.row(i).transpose(), double{table.channel(3)[at]},
                                    double{table.channel(4)[at]}));
    }
  }

  using Features = std::array<double, 5>;

  Features query(const Rig& rig, const Eigen::VectorXd& channels) const {
    const Eigen::VectorXd five = searchChannels(rig).fromRig * channels;
    return featuresOf(five.head<3>(), five[3], five[4]);
  }

  double distance(const Features& q, std::size_t entry, bool blue, bool green) const {
    double sum = 0.0;
    for (std::size_t f = 0; f < 5; ++f) {
      if ((f == 3 && !blue) || (f == 4 && !green)) continue;
      sum += (entries_[entry][f] - q[f]) * (entries_[entry][f] - q[f]);
    }
    return std::sqrt(sum);
  }

  // The lowest of the nearest entries that `allowed` lets through.
  template <typename Allowed>
  std::size_t nearest(const Features& q, bool blue, bool green, Allowed allowed) const {
    std::size_t best = 0;
    double least = 1e300;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      if (!allowed(i)) continue;
      const double d = distance(q, i, blue, green);
      if (d < least) {
        least = d;
        best = i;
      }
    }
    return best;
  }

  std::size_t threeStage(const Features& q, int carotene) const {
    const auto all = samples();
    const auto first =
        all[nearest(q, true, false, [&](std::size_t i) { return all[i][kCarotene] == carotene; })];
    const auto second = all[nearest(q, true, false, [&](std::size_t i) {
      return all[i][kMelanin] == first[kMelanin] && all[i][kMelaninBlend] == first[kMelaninBlend];
    })];
    return nearest(q, false, true, [&](std::size_t i) {
      return all[i][kMelanin] == first[kMelanin] && all[i][kMelaninBlend] == first[kMelaninBlend] &&
             all[i][kCarotene] == second[kCarotene];
    });
  }

 private:
  Features featuresOf(const Eigen::Vector3d& rgb, double sb, double sg) const {
    const Eigen::Vector3d lab = labFromXyz(toXyz_ * rgb, white_);
    return {lab[0], lab[1], lab[2], lightness(sb), lightness(sg)};
  }
  const std::vector<std::array<int, kParameterCount>>& samples() const {
    static const auto all = [&] {
      std::vector<std::array<int, kParameterCount>> list;
      for (std::size_t i = 0; i < table_.size(); ++i)
        list.push_back(table_.samples(i));
      return list;
    }();
    return all;
  }

  const SkinTable& table_;
  Eigen::Vector3d white_;
  Eigen::Matrix3d toXyz_;
  std::vector<Features> entries_;
};

class TableSearchTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    naive_ = std::make_unique<NaiveSearch>(*test::monitorTable());
    pixels_ = test::simulate(test::monitorRig(), drawPopulation(protocolPopulation(), kPixels, 77),
                             0.005);
    for (std::size_t i = 0; i < pixels_.count; ++i) {
      const Eigen::VectorXd channels = pixels_.at(i);
      queries_.push_back(test::monitorSearch()->features({channels.data(), 9}));
      exact_.push_back(naive_->query(test::monitorRig(), channels));
    }
  }

  void featuresAreTheDefinition() {
    for (std::size_t i = 0; i < queries_.size(); ++i) {
      for (std::size_t f = 0; f < 5; ++f)
        EXPECT_NEAR(queries_[i][f], exact_[i][f], 2e-4);
    }
  }

  void fullSearchIsTheDefinition() {
    std::vector<std::size_t> found(queries_.size());
    test::monitorSearch()->fullSearch(queries_, found);
    int same = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      const std::size_t expected =
          naive_->nearest(exact_[i], true, true, [](std::size_t) { return true; });
      same += found[i] == expected ? 1 : 0;
      EXPECT_NEAR(naive_->distance(exact_[i], found[i], true, true),
                  naive_->distance(exact_[i], expected, true, true), 1e-4);
    }
    qInfo("full search: %d of %d are the very same entry", same, kPixels);
    // The others lie at the same distance to rounding.
    QVERIFY(same >= kPixels * 95 / 100);
  }

  void threeStageIsTheDefinition() {
    int same = 0;
    for (std::size_t i = 0; i < queries_.size(); i += 4) {
      const int carotene = static_cast<int>(i / 4 % 5);
      const std::size_t expected = naive_->threeStage(exact_[i], carotene);
      same += test::monitorSearch()->threeStage(queries_[i], carotene) == expected ? 1 : 0;
    }
    qInfo("three stages: %d of %d are the very same entry", same, kPixels / 4);
    QVERIFY(same >= kPixels / 4 * 94 / 100);
  }

  // Channels of an entry itself lead back to it, or to one that looks the same.
  void entriesFindThemselves() {
    Random random(5);
    const SkinTable& table = *test::monitorTable();
    const SpectrumRows rows = responseRows(test::monitorRig());
    for (int turn = 0; turn < 40; ++turn) {
      const auto entry = static_cast<std::size_t>(random.uniform(0, double(table.size())));
      const Eigen::VectorXd channels =
          rows.matrix() * test::li2024().reflectance(table.parameters(entry)).matrix();
      const auto query = test::monitorSearch()->features({channels.data(), 9});
      std::size_t found = 0;
      test::monitorSearch()->fullSearch({&query, 1}, {&found, 1});
      const auto exact = naive_->query(test::monitorRig(), channels);
      EXPECT_AT_MOST(naive_->distance(exact, found, true, true), 2e-3);
    }
  }

  void withoutNarrowbandLightsWhiteDecides() {
    const auto rig = withLights(test::monitorRig(), {"white"}, "test").value();
    const auto table = std::make_shared<const SkinTable>(
        buildSkinTable(test::li2024(), searchTableRows(rig, test::light("D65"), test::cie1931()),
                       {})
            .value());
    const TableSearch search(table, rig, test::daylightWhite());
    QVERIFY(!search.hasNarrowband());
    for (std::size_t i = 0; i < 20; ++i) {
      const Eigen::VectorXd channels = pixels_.at(i);
      const auto query = search.features({channels.data(), 3});
      std::size_t found = 0;
      search.fullSearch({&query, 1}, {&found, 1});
      const std::size_t expected =
          naive_->nearest(exact_[i], false, false, [](std::size_t) { return true; });
      EXPECT_NEAR(naive_->distance(exact_[i], found, false, false),
                  naive_->distance(exact_[i], expected, false, false), 1e-4);
      QVERIFY(search.threeStage(query, 0) < table->size());
    }
  }

  // resources/manual/fitting.md: the fixed carotene comes out as 0 for li2024 and monitor.
  void theFixedCaroteneIsZero() {
    QCOMPARE(test::monitorSearch()->mostFrequentCarotene(test::li2024(), test::monitorRig(), 300),
             0);
  }

  void solversGiveTheEntriesParameters() {
    const auto channels =
        std::make_shared<const ResponseModel>(test::li2024(), responseRows(test::monitorRig()));
    const auto full = makeFullSearchSolver(test::monitorSearch(), channels);
    const auto staged = makeThreeStageSolver(test::monitorSearch(), 2, channels);
    QVERIFY(!full->hasDeviations() && !staged->hasDeviations());
    const test::Solutions a = test::solve(*full, pixels_);
    const test::Solutions b = test::solve(*staged, pixels_);
    std::vector<std::size_t> found(queries_.size());
    test::monitorSearch()->fullSearch(queries_, found);
    for (std::size_t i = 0; i < pixels_.count; ++i) {
      const SkinTable& table = *test::monitorTable();
      QVERIFY(((a.at(i) - table.parameters(found[i])).abs() < 1e-7).all());
      const std::size_t stage = test::monitorSearch()->threeStage(queries_[i], 2);
      QVERIFY(((b.at(i) - table.parameters(stage)).abs() < 1e-7).all());
      QVERIFY(a.states[i] == PixelState::solved);
      QCOMPARE(int{b.iterations[i]}, 0);
    }
  }

  void anythingFindsSomething() {
    const std::vector<std::vector<float>> odd = {std::vector<float>(9, 0.0f),
                                                 std::vector<float>(9, 1.0f),
                                                 std::vector<float>(9, 1e6f),
                                                 std::vector<float>(9, 3e38f),
                                                 {0, 0, 1, 0, 0, 1e6f, 5, 0, 0}};
    const auto channels =
        std::make_shared<const ResponseModel>(test::li2024(), responseRows(test::monitorRig()));
    for (const auto& solver : {makeFullSearchSolver(test::monitorSearch(), channels),
                               makeThreeStageSolver(test::monitorSearch(), 0, channels)}) {
      const test::Solutions solutions = test::solve(*solver, test::pixelsOf(odd));
      for (const float value : solutions.parameters)
        QVERIFY(value >= 0.0f && value <= 1.0f);
    }
  }

 private:
  std::unique_ptr<NaiveSearch> naive_;
  test::PixelSet pixels_;
  std::vector<SearchFeatures> queries_;
  std::vector<NaiveSearch::Features> exact_;
};

CUTIS_TEST(TableSearchTest)

}  // namespace
}  // namespace cutis

#include "table_search_test.moc"
