// Means of blocks of a picture.

#include "core/render/box_average.h"

#include <QtTest>

#include "tests/support/test_registry.h"

namespace cutis {
namespace {

class BoxAverageTest : public QObject {
  Q_OBJECT

 private slots:
  void blocksAtTheEdgesAreCut() {
    PictureBuffer picture;
    picture.width = 3;
    picture.height = 3;
    picture.channels = {{1, 2, 3, 4, 5, 6, 7, 8, 9}};
    picture.present.assign(9, true);
    const PictureBuffer averaged = boxAverage(picture, 2);
    QCOMPARE(averaged.width, 2);
    QCOMPARE(averaged.height, 2);
    QCOMPARE(averaged.channels.front(), (std::vector<float>{3.0f, 4.5f, 7.5f, 9.0f}));
    QCOMPARE(averaged.present, std::vector<bool>(4, true));
  }

  void whatHasNoEstimateCountsForNothing() {
    PictureBuffer picture;
    picture.width = 4;
    picture.height = 1;
    picture.channels = {{0.5f, 0.0f, 0.0f, 0.0f}};
    picture.present = {true, false, false, false};
    const PictureBuffer averaged = boxAverage(picture, 2);
    QCOMPARE(averaged.channels.front(), (std::vector<float>{0.5f, 0.0f}));
    QCOMPARE(averaged.present, (std::vector<bool>{true, false}));
  }

  void oneByOneIsThePictureItself() {
    PictureBuffer picture;
    picture.width = 2;
    picture.height = 1;
    picture.channels = {{0.25f, 0.75f}, {1.0f, 0.0f}};
    picture.present = {true, true};
    QCOMPARE(boxAverage(picture, 1).channels, picture.channels);
  }
};

CUTIS_TEST(BoxAverageTest)

}  // namespace
}  // namespace cutis

#include "box_average_test.moc"
