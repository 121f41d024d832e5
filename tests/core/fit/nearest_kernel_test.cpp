#include "core/fit/table/nearest_kernel.h"

#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include <QtTest>

#include "core/base/instruction_set.h"
#include "core/base/random.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr std::size_t kEntries = 4000;
constexpr std::size_t kRowPadding = 16;

struct Features {
  std::array<std::vector<float>, kMaximumFeatures> values;

  // Small integers: sums of squares are exact however they are summed.
  Features(int levels, std::uint64_t seed) {
    Random random(seed);
    for (auto& column : values) {
      for (std::size_t i = 0; i < kEntries; ++i) {
        column.push_back(static_cast<float>(std::floor(random.uniform(0.0, levels))));
      }
      // What a careless kernel would find past the end.
      column.resize(kEntries + kRowPadding, 0.0f);
    }
  }
};

NearestArguments argumentsOf(const Features& features, int featureCount,
                             const std::array<float, kMaximumFeatures>& query) {
  NearestArguments arguments = {};
  for (std::size_t f = 0; f < kMaximumFeatures; ++f) {
    arguments.features[f] = features.values[f].data();
    arguments.query[f] = query[f];
  }
  arguments.featureCount = featureCount;
  arguments.blockSize = kEntries;
  arguments.blockCount = 1;
  return arguments;
}

// The definition: first of the nearest, in the order of the entries.
Nearest naive(const NearestArguments& arguments, Nearest best) {
  for (std::size_t block = 0; block < arguments.blockCount; ++block) {
    for (std::size_t i = 0; i < arguments.blockSize; ++i) {
      const std::size_t at = arguments.first + block * arguments.blockStride + i;
      double distance = 0.0;
      for (int f = 0; f < arguments.featureCount; ++f) {
        const double difference = double{arguments.features[f][at]} - double{arguments.query[f]};
        distance += difference * difference;
      }
      if (distance < double{best.squaredDistance}) {
        best = {static_cast<float>(distance), static_cast<std::uint32_t>(at)};
      }
    }
  }
  return best;
}

std::array<float, kMaximumFeatures> randomQuery(Random& random, int levels) {
  std::array<float, kMaximumFeatures> query;
  for (float& value : query)
    value = static_cast<float>(std::floor(random.uniform(0.0, levels)));
  return query;
}

class NearestKernelTest : public QObject {
  Q_OBJECT

 private slots:
  void cleanup() { EXPECT_OK(pinInstructionSet("")); }

  void instructionSets() {
    QTest::addColumn<QString>("instructionSet");
    for (const char* name : {"scalar", "sse4", "avx2", "avx512"})
      QTest::newRow(name) << name;
  }

  // With few levels nearly every query has ties, in all lanes and blocks.
  void findsTheFirstOfTheNearest_data() { instructionSets(); }
  void findsTheFirstOfTheNearest() {
    QFETCH(QString, instructionSet);
    if (!pinInstructionSet(instructionSet.toStdString())) QSKIP("not on this processor");
    Random random(1);
    for (const int levels : {2, 4, 40}) {
      const Features features(levels, 10);
      for (int turn = 0; turn < 600; ++turn) {
        const int featureCount = 3 + turn % 3;
        NearestArguments arguments =
            argumentsOf(features, featureCount, randomQuery(random, levels));
        // Blocks of any size, apart by any stride, anywhere.
        arguments.blockSize = 1 + static_cast<std::size_t>(random.uniform(0, 70));
        arguments.blockStride =
            arguments.blockSize + static_cast<std::size_t>(random.uniform(0, 60));
        arguments.blockCount = 1 + static_cast<std::size_t>(random.uniform(0, 20));
        const std::size_t extent =
            (arguments.blockCount - 1) * arguments.blockStride + arguments.blockSize;
        arguments.first =
            static_cast<std::size_t>(random.uniform(0, static_cast<double>(kEntries - extent)));
        const Nearest expected = naive(arguments, {});
        const Nearest found = nearestOf(arguments, {});
        QCOMPARE(found.index, expected.index);
        QCOMPARE(found.squaredDistance, expected.squaredDistance);
      }
    }
  }

  // The same entry planted twice, in each pair of lanes: the lower one wins.
  void plantedTiesGoToTheLowerEntry_data() { instructionSets(); }
  void plantedTiesGoToTheLowerEntry() {
    QFETCH(QString, instructionSet);
    if (!pinInstructionSet(instructionSet.toStdString())) QSKIP("not on this processor");
    const Features far(1000, 20);
    for (std::size_t low = 0; low < 40; ++low) {
      for (std::size_t high = low + 1; high < 60; ++high) {
        Features features = far;
        for (auto& column : features.values)
          column[low] = column[high] = -5000.0f;
        NearestArguments arguments = argumentsOf(features, 5, {-5000, -5000, -5000, -5000, -5000});
        arguments.blockSize = 61;
        QCOMPARE(nearestOf(arguments, {}).index, static_cast<std::uint32_t>(low));
      }
    }
  }

  // Searching on from what an earlier part found: only something nearer replaces it.
  void earlierResultsStayOnEquality_data() { instructionSets(); }
  void earlierResultsStayOnEquality() {
    QFETCH(QString, instructionSet);
    if (!pinInstructionSet(instructionSet.toStdString())) QSKIP("not on this processor");
    Random random(2);
    const Features features(3, 30);
    for (int turn = 0; turn < 300; ++turn) {
      NearestArguments arguments = argumentsOf(features, 5, randomQuery(random, 3));
      const Nearest whole = nearestOf(arguments, {});
      QCOMPARE(whole.index, naive(arguments, {}).index);
      Nearest pieces = {};
      const auto piece = 1 + static_cast<std::size_t>(random.uniform(0, 900));
      for (std::size_t begin = 0; begin < kEntries; begin += piece) {
        arguments.first = begin;
        arguments.blockSize = std::min(piece, kEntries - begin);
        pieces = nearestOf(arguments, pieces);
      }
      QCOMPARE(pieces.index, whole.index);
      QCOMPARE(pieces.squaredDistance, whole.squaredDistance);
      QCOMPARE(nearestOf(argumentsOf(features, 5, {0, 0, 0, 0, 0}), {-1.0f, 7}).index, 7u);
    }
  }

  // Ordinary distances: the winner is nearest to rounding.
  void realDistancesAreNearest_data() { instructionSets(); }
  void realDistancesAreNearest() {
    QFETCH(QString, instructionSet);
    if (!pinInstructionSet(instructionSet.toStdString())) QSKIP("not on this processor");
    Random random(3);
    Features features(2, 40);
    for (auto& column : features.values) {
      for (float& value : column)
        value = static_cast<float>(random.uniform(-100.0, 100.0));
    }
    for (int turn = 0; turn < 200; ++turn) {
      std::array<float, kMaximumFeatures> query;
      for (float& value : query)
        value = static_cast<float>(random.uniform(-100.0, 100.0));
      NearestArguments arguments = argumentsOf(features, 5, query);
      const double least = double{naive(arguments, {}).squaredDistance};
      const Nearest found = nearestOf(arguments, {});
      arguments.first = found.index;
      arguments.blockSize = 1;
      EXPECT_NEAR(naive(arguments, {}).squaredDistance, least, 1e-6 * least);
    }
  }

  // Entries past the end of a block must not be found, however near they are.
  void doesNotLookPastTheEnd_data() { instructionSets(); }
  void doesNotLookPastTheEnd() {
    QFETCH(QString, instructionSet);
    if (!pinInstructionSet(instructionSet.toStdString())) QSKIP("not on this processor");
    Features features(1, 50);
    for (auto& column : features.values) {
      for (std::size_t i = 0; i < kEntries; ++i)
        column[i] = 9.0f;
      column[0] = 8.0f;
    }
    for (std::size_t size = 1; size < 40; ++size) {
      Features planted = features;
      for (auto& column : planted.values)
        column[100 + size] = 0.0f;
      NearestArguments arguments = argumentsOf(planted, 4, {0, 0, 0, 0, 0});
      arguments.first = 100;
      arguments.blockSize = size;
      QCOMPARE(nearestOf(arguments, {}).index, 100u);
    }
  }

  // A pixel that is not a number is near nothing; the answer is some entry, never a crash.
  void notANumberFindsTheFirst() {
    const Features features(5, 60);
    const float nan = std::numeric_limits<float>::quiet_NaN();
    QCOMPARE(nearestOf(argumentsOf(features, 5, {nan, 0, 0, 0, 0}), {}).index, 0u);
  }
};

CUTIS_TEST(NearestKernelTest)

}  // namespace
}  // namespace cutis

#include "nearest_kernel_test.moc"
