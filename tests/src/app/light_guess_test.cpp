#include "src/app/open/light_guess.h"

#include <QtTest>

#include "src/files/rig_file.h"
#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

std::vector<std::string> guessed(const std::vector<PhotographClues>& photographs, const Rig& rig) {
  std::vector<std::string> names;
  for (const LightGuess& guess : guessLights(photographs, rig)) {
    names.push_back(guess.light < 0 ? "" : rig.lights[static_cast<std::size_t>(guess.light)].name);
  }
  return names;
}

std::vector<PhotographClues> named(const std::vector<std::string>& names) {
  std::vector<PhotographClues> photographs;
  for (const std::string& name : names)
    photographs.push_back({name});
  return photographs;
}

using Names = std::vector<std::string>;

class LightGuessTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    auto rig = loadRig("monitor", {}, {});
    QVERIFY(static_cast<bool>(rig));
    rig_ = rig.value();
    QCOMPARE(rig_.lights.size(), 3u);  // white, white+blue, white+green
  }

  void namesTell_data() {
    QTest::addColumn<QStringList>("files");
    QTest::newRow("as lights") << QStringList{"white", "white+blue", "white+green"};
    QTest::newRow("numbered") << QStringList{"01_white", "02_white_blue", "03_white_green"};
    QTest::newRow("camel") << QStringList{"FaceWhite", "FaceWhiteBlue", "FaceWhiteGreen"};
    QTest::newRow("letters") << QStringList{"anna-w", "anna-w-b", "anna-w-g"};
    QTest::newRow("shouting") << QStringList{"WHITE", "WHITE BLUE", "WHITE GREEN"};
  }
  void namesTell() {
    QFETCH(QStringList, files);
    const Names inOrder = {"white", "white+blue", "white+green"};
    for (const auto& [order, lights] :
         {std::pair(std::array{0, 1, 2}, Names{inOrder[0], inOrder[1], inOrder[2]}),
          std::pair(std::array{2, 0, 1}, Names{inOrder[2], inOrder[0], inOrder[1]})}) {
      Names shuffled;
      for (const int k : order)
        shuffled.push_back(files[k].toStdString());
      QVERIFY(guessed(named(shuffled), rig_) == lights);
      for (const LightGuess& guess : guessLights(named(shuffled), rig_))
        QVERIFY(guess.clue == LightClue::name);
    }
  }

  // Whatever the camera's balance and the skin.
  void coloursTellWhereNamesDoNot() {
    const Eigen::Vector3d skin(0.9, 0.5, 0.3);
    std::vector<PhotographClues> photographs;
    for (const int light : {1, 2, 0}) {
      Eigen::Vector3d seen;
      for (int c = 0; c < 3; ++c) {
        seen[c] = skin[c] * (rig_.camera.sensor.sensitivity.row(c).transpose() *
                             rig_.lights[static_cast<std::size_t>(light)].power.array())
                                .sum();
      }
      photographs.push_back({"IMG_" + std::to_string(4000 + light), seen});
    }
    QVERIFY(guessed(photographs, rig_) == (Names{"white+blue", "white+green", "white"}));
    QVERIFY(guessLights(photographs, rig_).front().clue == LightClue::color);
  }

  // Photographs that were divided by their own white look alike; that is said.
  void whereNothingTellsTheOrderIsTaken() {
    std::vector<PhotographClues> photographs = named({"a1", "a2", "a3"});
    for (PhotographClues& photograph : photographs)
      photograph.color = {0.5, 0.4, 0.3};
    QVERIFY(guessed(photographs, rig_) == (Names{"white", "white+blue", "white+green"}));
    for (const LightGuess& guess : guessLights(photographs, rig_))
      QVERIFY(guess.clue == LightClue::order);
  }

  void noLightIsGivenTwice() {
    QVERIFY(guessed(named({"white", "white", "white_blue", "x", "y"}), rig_) ==
            (Names{"white", "white+green", "white+blue", "", ""}));
    QVERIFY(guessed(named({"x"}), Rig()) == Names{""});
  }

 private:
  Rig rig_;
};

CUTIS_TEST(LightGuessTest)

}  // namespace
}  // namespace cutis

#include "light_guess_test.moc"
