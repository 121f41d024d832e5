// Views of rows × pixels.

#include "core/base/pixel_rows.h"

#include <QtTest>

#include "tests/support/test_registry.h"

namespace cutis {
namespace {

class PixelRowsTest : public QObject {
  Q_OBJECT

 private slots:
  void aPartIsAViewOfTheWhole() {
    PixelBuffer<float> buffer(3, 10);
    const PixelRows<float> part = buffer.rows().part(4, 2);
    QCOMPARE(part.count, std::size_t{2});
    QCOMPARE(part.stride, std::size_t{10});
    for (std::size_t k = 0; k < 3; ++k)
      part.at(k, 1) = static_cast<float>(k + 1);
    for (std::size_t k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < 10; ++i)
        QCOMPARE(buffer[k][i], i == 5 ? static_cast<float>(k + 1) : 0.0f);
    }
  }

  void aBufferOwnsWhatItHolds() {
    PixelBuffer<double> original(2, 3);
    original[1][2] = 7.0;
    PixelBuffer<double> copy = original;
    QVERIFY(copy == original);
    copy[1][2] = 8.0;
    QVERIFY(!(copy == original));
    const PixelRows<const double> seen = original.rows();
    QCOMPARE(seen.at(1, 2), 7.0);
    QVERIFY(seen.row(1) == original[1].data());
  }
};

CUTIS_TEST(PixelRowsTest)

}  // namespace
}  // namespace cutis

#include "pixel_rows_test.moc"
