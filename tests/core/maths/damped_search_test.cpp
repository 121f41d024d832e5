#include "core/maths/damped_search.h"

#include <cmath>
#include <functional>

#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr int kSize = 5;
using Vector = EquationsOf<kSize>::Vector;
using Matrix = EquationsOf<kSize>::Matrix;

struct Residuals {
  Vector value;   // measured − modelled
  Matrix slopes;  // ∂modelled
};

using Problem = std::function<Residuals(const Vector&)>;

EquationsOf<kSize> equationsAt(const Problem& problem, const Vector& x) {
  const Residuals residuals = problem(x);
  return {residuals.slopes.transpose() * residuals.slopes,
          residuals.slopes.transpose() * residuals.value, residuals.value.squaredNorm()};
}

struct Outcome {
  Vector x;
  double cost = 0.0;
  int rounds = 0;
  bool converged = false;
};

Outcome searched(const Problem& problem, const Vector& start, const DampedSearchRules& rules = {}) {
  DampedSearch<kSize> search(rules);
  Vector x = start, step;
  search.accept(equationsAt(problem, x));
  while (search.next(x, 1e-20, step)) {
    const EquationsOf<kSize> trial = equationsAt(problem, x + step);
    if (search.improves(trial.cost)) {
      x += step;
      search.accept(trial);
    } else {
      search.reject();
    }
  }
  return {x, search.cost(), search.rounds(), search.converged()};
}

Vector evenly(double first, double step) {
  return Vector::LinSpaced(kSize, first, first + step * (kSize - 1));
}

// Measured − modelled of a model that is linear in x, with its best point at `best`.
Problem linearProblem(const Vector& best) {
  Matrix slopes = Matrix::Identity();
  slopes.diagonal(1).setConstant(0.3);
  return [=](const Vector& x) { return Residuals{slopes * (best - x), slopes}; };
}

class DampedSearchTest : public QObject {
  Q_OBJECT

 private slots:
  void findsTheBestPointOfALinearModelAtOnce() {
    const Vector best = evenly(0.2, 0.1);
    const Outcome outcome = searched(linearProblem(best), Vector::Constant(0.5));
    QVERIFY(outcome.converged);
    QVERIFY(outcome.rounds <= 3);
    QVERIFY((outcome.x - best).cwiseAbs().maxCoeff() < 1e-8);
  }

  void staysInTheBoxWhereTheBestPointLiesOutside() {
    Vector best = evenly(0.2, 0.1);
    best[0] = -1.0;
    best[4] = 2.0;
    const Outcome outcome = searched(linearProblem(best), Vector::Constant(0.5));
    QVERIFY(outcome.converged);
    QCOMPARE(outcome.x[0], 0.0);
    QCOMPARE(outcome.x[4], 1.0);
    // Where the box holds a coordinate, the others move on to what is best beside it: no small
    // move of a free one lowers the cost.
    for (int i = 1; i < 4; ++i) {
      for (const double move : {-1e-4, 1e-4}) {
        Vector beside = outcome.x;
        beside[i] += move;
        QVERIFY(equationsAt(linearProblem(best), beside).cost >= outcome.cost);
      }
    }
  }

  // Rosenbrock's valley: an undamped step overshoots there and has to be rejected.
  void followsACurvedValley() {
    const Problem valley = [](const Vector& x) {
      const Vector t = 4.0 * x - Vector::Constant(2.0);
      Residuals residuals{Vector::Zero(), Matrix::Zero()};
      residuals.value << 1.0 - t[0], -10.0 * (t[1] - t[0] * t[0]), 0.3 - x[2], 0.6 - x[3],
          0.9 - x[4];
      residuals.slopes(0, 0) = 4.0;
      residuals.slopes(1, 0) = -80.0 * t[0];
      residuals.slopes(1, 1) = 40.0;
      for (int i = 2; i < kSize; ++i)
        residuals.slopes(i, i) = 1.0;
      return residuals;
    };
    Vector start = Vector::Constant(0.5);
    start[0] = 0.1;
    start[1] = 0.9;
    const Outcome outcome = searched(valley, start);
    QVERIFY(outcome.converged);
    EXPECT_NEAR(outcome.x[0], 0.75, 1e-7);
    EXPECT_NEAR(outcome.x[1], 0.75, 1e-7);
    EXPECT_NEAR(outcome.x[4], 0.9, 1e-7);
  }

  void endsUnconvergedWithItsRounds() {
    DampedSearchRules rules;
    rules.maximumRounds = 1;
    const Problem bent = [](const Vector& x) {
      return Residuals{(0.25 - x.array().exp()).matrix(), x.array().exp().matrix().asDiagonal()};
    };
    const Outcome outcome = searched(bent, Vector::Constant(0.9), rules);
    QVERIFY(!outcome.converged);
    QVERIFY(outcome.cost < equationsAt(bent, Vector::Constant(0.9)).cost);
  }

  void searchesSideBySideEndEachForItself() {
    struct Countdown {
      int left;
    };
    std::vector<Countdown> searches = {{3}, {1}, {2}};
    std::vector<std::size_t> active;
    const auto evaluate = [&](const std::vector<Countdown*>& running) {
      active.push_back(running.size());
      return std::vector<int>(running.size(), 1);
    };
    const auto advance = [](Countdown& search, int came) { return (search.left -= came) > 0; };
    QVERIFY(runSearches(searches, evaluate, advance, [] { return false; }));
    QCOMPARE(active, (std::vector<std::size_t>{3, 2, 1}));
    searches = {{3}};
    QVERIFY(!runSearches(searches, evaluate, advance, [] { return true; }));
  }
};

CUTIS_TEST(DampedSearchTest)

}  // namespace
}  // namespace cutis

#include "damped_search_test.moc"
