// The rules on headers and rooms, on made-up snippets: what they let through, and that they can
// fail.

#include "tests/architecture/header_rules.h"

#include <QtTest>

#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

constexpr char kFace[] = "#pragma once\n\n// A face.\n";
constexpr char kInner[] = "#pragma once  // internal to core/skin/free\n\n// A part.\n";
constexpr char kUse[] = "#include \"core/skin/free/a.h\"\n";

class HeaderRulesTest : public QObject {
  Q_OBJECT

 private slots:
  void headersOpenWithASentence() {
    QVERIFY(checkOpening("a.h", "#pragma once\n\n// What it is.\n\nint x;\n").empty());
    QVERIFY(checkOpening("a.h", "#pragma once\n\n// What it is and\n// what not: this.\n").empty());
    QVERIFY(checkOpening("a-inl.h", "// What it is.\n\n#if defined(A)\n").empty());
    QVERIFY(!checkOpening("a.h", "#pragma once\n\n#include <vector>\n\nint x;\n").empty());
    QVERIFY(!checkOpening("a.h", "#pragma once\n\nint x;\n// Too late.\n").empty());
    QVERIFY(
        !checkOpening("a.h", "#pragma once\n\n// some words\n//\n// And a sentence.\n").empty());
    // The mark of an internal header is not an opening.
    QVERIFY(!checkOpening("a.h", "#pragma once  // internal to ui/view\n\nint x;\n").empty());
  }

  void aMarkNamesItsRoom() {
    QCOMPARE(markedRoom(kInner), std::string("core/skin/free"));
    QCOMPARE(markedRoom(kFace), std::string());
  }

  void internalHeadersStayInTheirRoom() {
    const auto check = [](const char* header, const char* user) {
      return checkInternal({{"core/skin/free/a.h", header}, {user, kUse}});
    };
    QVERIFY(check(kInner, "core/skin/free/b.cpp").empty());
    QVERIFY(check(kFace, "core/fit/b.cpp").empty());
    QCOMPARE(check(kInner, "core/fit/b.cpp").front(),
             std::string("core/skin/free/a.h is internal, but core/fit includes it"));
    // The room above is another room.
    QCOMPARE(check(kInner, "core/skin/b.cpp").size(), std::size_t{1});
    QCOMPARE(check(kFace, "core/skin/free/b.cpp").size(), std::size_t{1});
    const auto moved = checkInternal({{"core/skin/model/a.h", kInner}});
    QCOMPARE(moved.size(), std::size_t{1});
    QVERIFY(checkInternal({{"core/skin/free/a-inl.h", kFace}}).empty());
  }

  void roomsAreSmall() {
    SourceTree tree;
    for (std::size_t i = 0; i < kMaximumFiles; ++i)
      tree["core/skin/" + std::to_string(i) + ".cpp"] = "";
    tree["core/skin/free/a.cpp"] = "";
    QVERIFY(checkRoomSizes(tree).empty());
    tree["core/skin/a.h"] = "";
    QCOMPARE(checkRoomSizes(tree).size(), std::size_t{1});
  }
};

CUTIS_TEST(HeaderRulesTest)

}  // namespace
}  // namespace cutis::test

#include "header_rules_test.moc"
