#include "ui/docks/dock_column.h"

#include <numeric>

#include <QtTest>

#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using Heights = std::vector<int>;

class DockColumnTest : public QObject {
  Q_OBJECT

 private slots:
  void theRestGoesToTheLast() {
    QCOMPARE(settledHeights({{200, 100, false}, {100, 100, false}, {100, 150, false}}),
             (Heights{100, 100, 200}));
    QCOMPARE(settledHeights({{500, 100, false}}), (Heights{500}));
    QCOMPARE(settledHeights({}), Heights{});
  }

  void whatGrowsHasTheRestWhereverItIs() {
    QCOMPARE(settledHeights({{300, 100, true}, {300, 100, false}}), (Heights{500, 100}));
    QCOMPARE(settledHeights({{300, 100, true}, {100, 100, true}, {200, 200, false}}),
             (Heights{250, 150, 200}));
  }

  // What the user took from one stays with the others, as far as they need it.
  void withoutRoomTheUpperOnesAreFilledFirst() {
    QCOMPARE(settledHeights({{50, 200, false}, {150, 200, false}, {100, 200, false}}),
             (Heights{50, 150, 100}));
    QCOMPARE(settledHeights({{50, 200, false}, {100, 200, false}, {250, 200, false}}),
             (Heights{100, 100, 200}));
  }

  // Sliders are missed where they are out of sight; lists can be scrolled.
  void listsGiveWayToPanels() {
    QCOMPARE(settledHeights({{100, 300, false}, {200, 150, true, 60}}), (Heights{240, 60}));
    QCOMPARE(settledHeights({{100, 120, false}, {80, 150, true, 60}}), (Heights{120, 60}));
    QCOMPARE(settledHeights({{100, 200, false}, {80, 90, false}, {50, 90, true, 60}}),
             (Heights{100, 80, 50}));
  }

  void nothingIsLostByRounding() {
    for (int height = 1; height < 400; height += 7) {
      const std::vector<ColumnPlace> places = {
          {height, 31, true}, {77, 50, false}, {height / 3, 40, true}, {13, 20, true}};
      const Heights heights = settledHeights(places);
      const int now =
          std::accumulate(places.begin(), places.end(), 0,
                          [](int sum, const ColumnPlace& place) { return sum + place.height; });
      QCOMPARE(std::accumulate(heights.begin(), heights.end(), 0), now);
    }
  }
};

CUTIS_TEST(DockColumnTest)

}  // namespace
}  // namespace cutis

#include "dock_column_test.moc"
