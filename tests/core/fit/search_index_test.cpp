#include "core/fit/table/search_index.h"

#include <vector>

#include <QtTest>

#include "core/base/random.h"
#include "core/fit/population.h"
#include "tests/core/fit/fit_fixture.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr int kQueries = 1500;

// Measured skin, skin with noise, entries of the table themselves (distance zero, and entries with
// equal features), and colours no skin has.
std::vector<SearchFeatures> mixedQueries(const TableSearch& search) {
  std::vector<SearchFeatures> queries;
  const auto people = drawPopulation(protocolPopulation(), kQueries / 3, 11);
  for (const double noise : {0.0, 0.02}) {
    const test::PixelSet pixels = test::simulate(test::monitorRig(), people, noise);
    for (std::size_t i = 0; i < pixels.count; ++i) {
      const Eigen::VectorXd channels = pixels.at(i);
      queries.push_back(
          search.features({channels.data(), static_cast<std::size_t>(channels.size())}));
    }
  }
  Random random(12);
  while (queries.size() < kQueries) {
    SearchFeatures query = {};
    const auto entry =
        static_cast<std::size_t>(random.uniform(0.0, static_cast<double>(search.table().size())));
    const bool skin = random.uniform() < 0.7;
    for (std::size_t f = 0; f < query.size(); ++f) {
      query[f] = skin ? search.featureOfEntries(static_cast<int>(f))[entry]
                      : static_cast<float>(random.uniform(-120.0, 160.0));
    }
    queries.push_back(query);
  }
  return queries;
}

class SearchIndexTest : public QObject {
  Q_OBJECT

 private slots:
  void fullSearchFindsTheSameEntries() {
    const auto search = test::monitorSearch();
    const FullSearchIndex index(search);
    const auto queries = mixedQueries(*search);
    std::vector<std::size_t> exhaustive(queries.size());
    search->fullSearch(queries, exhaustive);
    for (std::size_t q = 0; q < queries.size(); ++q) {
      QCOMPARE(index.nearest(queries[q]), exhaustive[q]);
    }
  }

  void threeStagesFindTheSameEntries_data() {
    QTest::addColumn<int>("carotene");
    QTest::newRow("lowest") << 0;
    QTest::newRow("third") << 2;
  }
  void threeStagesFindTheSameEntries() {
    QFETCH(int, carotene);
    const auto search = test::monitorSearch();
    const ThreeStageIndex index(search, carotene);
    for (const SearchFeatures& query : mixedQueries(*search)) {
      QCOMPARE(index.nearest(query), search->threeStage(query, carotene));
    }
  }
};

CUTIS_TEST(SearchIndexTest)

}  // namespace
}  // namespace cutis

#include "search_index_test.moc"
