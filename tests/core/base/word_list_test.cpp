#include "core/base/word_list.h"

#include <array>
#include <string>
#include <vector>

#include <QtTest>

#include "tests/support/test_registry.h"

namespace cutis {
namespace {

class WordListTest : public QObject {
  Q_OBJECT

 private slots:
  void wordsAreJoined() {
    using Words = std::vector<std::string>;
    QCOMPARE(wordList(Words{}, " and "), std::string());
    QCOMPARE(wordList(Words{"R"}, " and "), std::string("R"));
    QCOMPARE(wordList(Words{"R", "G"}, " and "), std::string("R and G"));
    QCOMPARE(wordList(Words{"R", "G", "B"}, " or "), std::string("R, G or B"));
    QCOMPARE(wordList(Words{"R", "", "B"}, " and "), std::string("R,  and B"));
    QCOMPARE(wordList(std::array<const char*, 3>{"a", "b", "c"}, ", "), std::string("a, b, c"));
    QCOMPARE(wordList(std::vector<std::string_view>{"a", "b"}, ", "), std::string("a, b"));
  }
};

CUTIS_TEST(WordListTest)

}  // namespace
}  // namespace cutis

#include "word_list_test.moc"
