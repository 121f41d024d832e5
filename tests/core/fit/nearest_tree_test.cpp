#include "core/fit/table/nearest_tree.h"

#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <vector>

#include <QtTest>

#include "core/base/instruction_set.h"
#include "core/base/random.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr std::size_t kPadding = 16;

struct Points {
  std::array<std::vector<float>, kMaximumFeatures> values;
  std::size_t count;

  // Whole numbers tie often; levels 0: any number from −100 to 100.
  Points(std::size_t pointCount, int levels, std::uint64_t seed) : count(pointCount) {
    Random random(seed);
    for (auto& column : values) {
      for (std::size_t i = 0; i < count; ++i)
        column.push_back(coordinate(random, levels));
      column.resize(count + kPadding, 0.0f);
    }
  }

  static float coordinate(Random& random, int levels) {
    return levels == 0 ? static_cast<float>(random.uniform(-100.0, 100.0))
                       : static_cast<float>(std::floor(random.uniform(0.0, levels)));
  }

  NearestTree tree(int featureCount, std::vector<std::uint32_t> entries) const {
    std::vector<std::span<const float>> columns;
    for (int f = 0; f < featureCount; ++f) {
      columns.push_back(std::span<const float>(values[static_cast<std::size_t>(f)]).first(count));
    }
    return NearestTree(columns, std::move(entries));
  }

  std::uint32_t exhaustive(int featureCount,
                           const std::array<float, kMaximumFeatures>& query) const {
    NearestArguments arguments = {};
    for (std::size_t f = 0; f < kMaximumFeatures; ++f) {
      arguments.features[f] = values[f].data();
      arguments.query[f] = query[f];
    }
    arguments.featureCount = featureCount;
    arguments.blockSize = count;
    arguments.blockCount = 1;
    return nearestOf(arguments, {}).index;
  }
};

std::vector<std::uint32_t> numbersBelow(std::size_t count) {
  std::vector<std::uint32_t> numbers(count);
  std::iota(numbers.begin(), numbers.end(), 0u);
  return numbers;
}

class NearestTreeTest : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { EXPECT_OK(pinInstructionSet("")); }

  // 100,000 queries in all, most of them with ties, some on entries and some far away.
  void findsWhatExhaustiveSearchFinds_data() {
    QTest::addColumn<QString>("instructionSet");
    QTest::addColumn<int>("levels");
    for (const char* name : {"scalar", "sse4", "avx2", "avx512"}) {
      for (const int levels : {0, 2, 5, 30}) {
        QTest::newRow(qPrintable(QString("%1, %2 levels").arg(name).arg(levels))) << name << levels;
      }
    }
  }
  void findsWhatExhaustiveSearchFinds() {
    QFETCH(QString, instructionSet);
    QFETCH(int, levels);
    if (!pinInstructionSet(instructionSet.toStdString())) QSKIP("not on this processor");
    Random random(static_cast<std::uint64_t>(levels) + 7);
    for (const std::size_t count : {1u, 15u, 16u, 17u, 130u, 1000u, 3001u}) {
      const Points points(count, levels, count);
      for (const int featureCount : {3, 4, 5}) {
        const NearestTree tree = points.tree(featureCount, numbersBelow(count));
        for (int turn = 0; turn < 400; ++turn) {
          std::array<float, kMaximumFeatures> query;
          for (float& value : query)
            value = Points::coordinate(random, levels);
          if (turn % 7 == 0) query[0] += 1000.0f;
          QCOMPARE(tree.nearest(std::span(query).first(static_cast<std::size_t>(featureCount))),
                   points.exhaustive(featureCount, query));
        }
      }
    }
  }

  // One point many times over: the lowest of its numbers, wherever the tree has put them.
  void ofEqualPointsTheLowestIsFound() {
    Points points(4000, 0, 3);
    for (auto& column : points.values) {
      for (std::size_t i = 1234; i < points.count; i += 3)
        column[i] = 5.0f;
    }
    const NearestTree tree = points.tree(5, numbersBelow(points.count));
    const std::array<float, kMaximumFeatures> near = {5.0f, 5.0f, 5.0f, 5.0f, 5.0f};
    QCOMPARE(tree.nearest(near), 1234u);
  }

  void onlyListedEntriesAreFound() {
    const Points points(3000, 3, 4);
    std::vector<std::uint32_t> every;
    for (std::uint32_t i = 2; i < points.count; i += 10)
      every.push_back(i);
    const NearestTree tree = points.tree(4, every);
    Random random(5);
    for (int turn = 0; turn < 500; ++turn) {
      std::array<float, 4> query;
      for (float& value : query)
        value = Points::coordinate(random, 3);
      QCOMPARE(tree.nearest(query) % 10, 2u);
    }
  }

  void whatIsNotFiniteFindsTheFirst() {
    const Points points(100, 0, 6);
    const NearestTree tree = points.tree(3, numbersBelow(points.count));
    for (const float odd :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(),
          -std::numeric_limits<float>::infinity()}) {
      const std::array<float, 3> query = {1.0f, odd, 2.0f};
      QCOMPARE(tree.nearest(query), 0u);
    }
  }
};

CUTIS_TEST(NearestTreeTest)

}  // namespace
}  // namespace cutis

#include "nearest_tree_test.moc"
