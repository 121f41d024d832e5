// Edits as text: written and read they are the same; what this version cannot do is refused, what
// it does not know is said.

#include "src/files/edits/edits_file.h"

#include <string>
#include <vector>

#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

EditStack someEdits() {
  Edit tan;
  tan.name = "Tan, a little";
  tan.opacity = 1.0 / 3.0;
  tan.parameters[kMelanin].scale = 1.4;
  tan.parameters[kHaemoglobinDermal].add = -0.01;
  Edit pale;
  pale.enabled = false;
  pale.parameters[kMelanin].scale = 0.5;
  pale.parameters[kMelanin].add = 0.02;
  pale.parameters[kCarotene].set = 0.0;
  return {tan, pale};
}

bool sameEdit(const Edit& a, const Edit& b) {
  return a.name == b.name && a.parameters == b.parameters && a.opacity == b.opacity &&
         a.enabled == b.enabled;
}

// Text of one edit with these fields.
std::string textWith(const std::string& fields, const std::string& version = "1") {
  return R"({"cutis_edits": )" + version + R"(, "edits": [{)" + fields + "}]}";
}

class EditsFileTest : public QObject {
  Q_OBJECT

 private Q_SLOTS:
  void editsSurviveTheText() {
    const std::string text = editsText(someEdits());
    const auto read = readEdits(text, "tan.json", {});
    EXPECT_OK(read);
    QCOMPARE(read.value().size(), std::size_t{2});
    QVERIFY(sameEdit(read.value()[0], someEdits()[0]));
    QVERIFY(sameEdit(read.value()[1], someEdits()[1]));
    QCOMPARE(editsText(read.value()), text);
  }

  void noEditsAreAListOfNone() {
    const auto read = readEdits(editsText({}), "none.json", {});
    EXPECT_OK(read);
    QVERIFY(read.value().empty());
  }

  void whatIsLeftOutIsNeutral() {
    const auto read = readEdits(textWith(""), "short.json", {});
    EXPECT_OK(read);
    QVERIFY(read.value().front().isNeutral());
    QVERIFY(sameEdit(read.value().front(), Edit()));
  }

  void whatItCannotDoIsRefused_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("sentence");
    const auto row = [](const char* name, const std::string& text, const char* sentence) {
      QTest::newRow(name) << QString::fromStdString(text) << QString(sentence);
    };
    row("newer", textWith("", "2"), "cutis_edits is 2, written by a newer version");
    row("other file", R"({"edits": []})", "\"cutis_edits\": 1 is missing");
    row("no list", R"({"cutis_edits": 1})", "p.json: edits must be a list (it is missing)");
    row("mode", textWith(R"("melanin": {"mode": "even", "value": 1})"),
        "p.json: edits[0].melanin.mode must be \"scale\", \"add\" or \"set\" in this version, not "
        "'even'; leave the edit out or use a newer version");
    row("no value", textWith(R"("melanin": {"mode": "set"})"),
        "edits[0].melanin.value must be a number (it is missing)");
    row("factor", textWith(R"("melanin": {"mode": "scale", "value": -1})"),
        "edits[0].melanin.value must be from 0 to 1000");
    row("opacity", textWith(R"("opacity": 1.5)"), "edits[0].opacity must be from 0 to 1");
    row("on", textWith(R"("on": 1)"), "edits[0].on must be true or false");
    row("region", textWith(R"("region": "cheek")"), "edits[0].region must be null in this version");
    row("regions", R"({"cutis_edits": 1, "edits": [], "regions": [{"name": "cheek"}]})",
        "regions must be empty in this version");
    row("no object", R"({"cutis_edits": 1, "edits": [1]})", "edits[0] must be an object");
    row("not JSON", "{\"cutis_edits\": 1,\n  oops}", "p.json:2:3: not valid JSON");
  }

  void whatItCannotDoIsRefused() {
    QFETCH(QString, text);
    QFETCH(QString, sentence);
    EXPECT_ERROR(readEdits(text.toStdString(), "p.json", {}), sentence.toStdString());
  }

  void whatItDoesNotKnowIsSaid() {
    std::vector<std::string> notes;
    const auto read =
        readEdits(textWith(R"("colour": 1, "melanin": {"mode": "add", "value": 0.1, "add": 1})"),
                  "p.json", [&](const std::string& sentence) { notes.push_back(sentence); });
    EXPECT_OK(read);
    QCOMPARE(notes, (std::vector<std::string>{
                        "p.json: 'edits[0].melanin.add' means nothing to this version and is "
                        "passed over",
                        "p.json: 'edits[0].colour' means nothing to this version and is passed "
                        "over"}));
  }
};

CUTIS_TEST(EditsFileTest)

}  // namespace
}  // namespace cutis

#include "edits_file_test.moc"
