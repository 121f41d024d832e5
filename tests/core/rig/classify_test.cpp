#include <array>
#include <limits>

#include <QtTest>

#include "core/rig/measurements.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

constexpr float kNotANumber = std::numeric_limits<float>::quiet_NaN();
constexpr float kEndless = std::numeric_limits<float>::infinity();

class ClassifyTest : public QObject {
  Q_OBJECT

 private slots:
  void truthTable_data() {
    QTest::addColumn<QVector<float>>("channels");
    QTest::addColumn<float>("mask");
    QTest::addColumn<bool>("clipped");
    QTest::addColumn<int>("state");
    const QVector<float> skin = {0.5f, 0.3f, 0.2f};
    constexpr int solved = 0, masked = 1, invalid = 2, saturated = 3;  // as they stand in files
    QTest::newRow("skin") << skin << 1.0f << false << solved;
    QTest::newRow("brighter than the diffuser")
        << QVector<float>{1.5f, 1.2f, 2.0f} << 1.0f << false << solved;
    QTest::newRow("half a mask") << skin << 0.5f << false << solved;
    QTest::newRow("a trace of mask") << skin << 1e-30f << false << solved;
    QTest::newRow("no mask") << skin << 0.0f << false << masked;
    QTest::newRow("negative zero mask") << skin << -0.0f << false << masked;
    QTest::newRow("negative mask") << skin << -1.0f << false << masked;
    QTest::newRow("mask not a number") << skin << kNotANumber << false << masked;
    QTest::newRow("masked and clipped") << skin << 0.0f << true << masked;
    QTest::newRow("masked and invalid")
        << QVector<float>{kNotANumber, 1, 1} << 0.0f << false << masked;
    QTest::newRow("clipped") << skin << 1.0f << true << saturated;
    QTest::newRow("clipped, half a mask") << skin << 0.5f << true << saturated;
    QTest::newRow("not a number") << QVector<float>{0.5f, kNotANumber, 0.2f} << 1.0f << false
                                  << invalid;
    QTest::newRow("infinite") << QVector<float>{0.5f, 0.3f, kEndless} << 1.0f << false << invalid;
    QTest::newRow("minus infinite")
        << QVector<float>{-kEndless, 0.3f, 1} << 1.0f << false << invalid;
    QTest::newRow("infinite and clipped")
        << QVector<float>{kEndless, 1, 1} << 1.0f << true << invalid;
    QTest::newRow("negative") << QVector<float>{0.5f, -1e-9f, 0.2f} << 1.0f << false << invalid;
    QTest::newRow("black") << QVector<float>{0, 0, 0} << 1.0f << false << invalid;
    QTest::newRow("negative zeros") << QVector<float>{-0.0f, -0.0f, 0} << 1.0f << false << invalid;
    QTest::newRow("black and clipped") << QVector<float>{0, 0, 0} << 1.0f << true << invalid;
    QTest::newRow("one channel lit") << QVector<float>{0, 0, 1e-6f} << 1.0f << false << solved;
  }
  void truthTable() {
    QFETCH(QVector<float>, channels);
    QFETCH(float, mask);
    QFETCH(bool, clipped);
    QFETCH(int, state);
    const std::span<const float> values(channels.constData(),
                                        static_cast<std::size_t>(channels.size()));
    QCOMPARE(static_cast<int>(classify(values, mask, clipped)), state);
  }
};

CUTIS_TEST(ClassifyTest)

}  // namespace
}  // namespace cutis

#include "classify_test.moc"
