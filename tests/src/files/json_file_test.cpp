#include "src/files/io/json_file.h"

#include <QtTest>

#include "tests/support/expect.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

class JsonFileTest : public QObject {
  Q_OBJECT

 private slots:
  // Columns count characters, from 1, as editors do.
  void syntaxErrorsSayWhere_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("place");
    const auto row = [](const char* name, const char* text, const char* place) {
      QTest::newRow(name) << QByteArray(text) << QString(place);
    };
    row("value missing", R"({"a": })", "f.json:1:7");
    row("comma too many", R"({"a": 1,})", "f.json:1:9");
    row("colon missing", R"({"a" 1})", "f.json:1:6");
    row("third line", "{\n  \"name\": \"x\",\n  \"lights\": [1 2]\n}", "f.json:3:16");
    row("CRLF", "{\r\n  \"a\": ?\r\n}", "f.json:2:8");
    row("byte order mark", "\xEF\xBB\xBF{\n?}", "f.json:2:1");
    row("byte order mark, first line", "\xEF\xBB\xBF{?}", "f.json:1:2");
    row("after umlauts", "{\"ä\": \"häm\", ?}", "f.json:1:14");
    row("end of file", "{\n\"a\": 1", "f.json:2:7");
    row("end of file after a newline", "{\n\"a\": 1\n", "f.json:3:1");
    row("text without end", "{\"a\": \"abc", "f.json:1:11");
    row("line break in a text", "{\n\"a\": \"ab\nc\"}", "f.json:2:9");
    row("comment", "{\n  // no\n}", "f.json:2:3");
    row("two documents", "{} {}", "f.json:1:4");
    row("nothing but blanks", "  ", "f.json:1:3");
    row("not UTF-8", "{\"a\": \"\xff\"}", "f.json:1:8");
  }
  void syntaxErrorsSayWhere() {
    QFETCH(QByteArray, text);
    QFETCH(QString, place);
    const auto result = parseJson({text.constData(), std::size_t(text.size())}, "f.json");
    QVERIFY(result.failed());
    QCOMPARE(QString::fromStdString(result.error().place), place);
    QVERIFY(result.error().kind == ErrorKind::input);
    QVERIFY2(result.error().message.find('\n') == std::string::npos, "one line");
    QVERIFY2(result.error().message.find("json.exception") == std::string::npos,
             result.error().message.c_str());
  }

  void theRootIsAnObject() {
    for (const char* text : {"[1]", "1", "\"a\"", "null", "true"}) {
      EXPECT_ERROR(parseJson(text, "f.json"), "f.json: ");
      EXPECT_ERROR(parseJson(text, "f.json"), "object");
    }
    EXPECT_OK(parseJson("\xEF\xBB\xBF{}", "f.json"));
  }

  void wrongTypesNameTheirField() {
    const auto parsed = parseJson(
        R"({"lights": [{"name": 7}, {"name": "b", "mix": {"R": "x", "G": 1e999}}],
            "none": null, "text": "t", "number": 1.5, "list": [1, "2"]})",
        "rig.json");
    // 1e999 is no number that a computer has.
    EXPECT_ERROR(parsed, "rig.json");
    const auto root = parseJson(
        R"({"lights": [{"name": 7}, {"name": "b", "mix": {"R": "x"}}],
            "none": null, "text": "t", "number": 1.5, "list": [1, "2"]})",
        "rig.json");
    EXPECT_OK(root);
    const JsonValue& value = root.value();
    const auto lights = value.array("lights");
    EXPECT_OK(lights);
    EXPECT_ERROR(lights.value()[0].text("name"), "rig.json: lights[0].name must be a text");
    const auto mix = lights.value()[1].object("mix");
    EXPECT_OK(mix);
    EXPECT_ERROR(mix.value().number("R"), "rig.json: lights[1].mix.R must be a finite number");
    EXPECT_ERROR(mix.value().number("G"), "lights[1].mix.G must be a number (it is missing)");
    EXPECT_ERROR(value.object("text"), "text must be an object");
    EXPECT_ERROR(value.array("text"), "text must be a list");
    EXPECT_ERROR(value.integer("number"), "number must be a whole number");
    EXPECT_ERROR(value.text("number"), "number must be a text");
    const auto list = value.array("list");
    EXPECT_OK(list);
    EXPECT_OK(list.value()[0].asNumber());
    EXPECT_ERROR(list.value()[1].asNumber(), "list[1] must be a finite number");
    QCOMPARE(list.value()[1].asText().value(), std::string("2"));
    EXPECT_ERROR(list.value()[0].asText(), "list[0] must be a text");
    QVERIFY(mix.value().keys() == std::vector<std::string>{"R"});
    EXPECT_ERROR(value.object("missing"), "(it is missing)");
  }

  // A value of the wrong type is not an absent one.
  void fallbacksAreForAbsentFieldsOnly() {
    const auto root = parseJson(R"({"n": null, "t": 3, "x": 2.5})", "f.json");
    EXPECT_OK(root);
    EXPECT_NEAR(root.value().number("absent", 7.0).value(), 7.0, 0.0);
    EXPECT_NEAR(root.value().number("x", 7.0).value(), 2.5, 0.0);
    QCOMPARE(root.value().text("absent", "f").value(), std::string("f"));
    EXPECT_ERROR(root.value().number("n", 7.0), "n must be");
    EXPECT_ERROR(root.value().text("t", "f"), "t must be a text");
  }

  void wholeNumbersHaveARange() {
    const auto root = parseJson(
        R"({"a": 2147483647, "b": -2147483648, "c": 2147483648, "d": 18446744073709551615,
            "e": 1e3, "f": 9223372036854775808})",
        "f.json");
    EXPECT_OK(root);
    QCOMPARE(root.value().integer("a").value(), 2147483647);
    QCOMPARE(root.value().integer("b").value(), -2147483647 - 1);
    EXPECT_ERROR(root.value().integer("c"), "c must be a smaller whole number");
    EXPECT_ERROR(root.value().integer("d"), "d must be a smaller whole number");
    EXPECT_ERROR(root.value().integer("e"), "e must be a whole number");
    EXPECT_ERROR(root.value().integer("f"), "f must be a smaller whole number");
  }

  void unknownFieldsAreRefused() {
    const auto root = parseJson(R"({"camera": {"sensitivty": "x"}})", "rig.json");
    EXPECT_OK(root);
    EXPECT_OK(root.value().allowOnly({"camera", "lights"}));
    const auto camera = root.value().object("camera");
    EXPECT_OK(camera);
    EXPECT_ERROR(camera.value().allowOnly({"sensitivity"}),
                 "rig.json: unknown field 'camera.sensitivty'; known here: sensitivity");
  }

  void versionsAreChecked() {
    const auto check = [](const char* text) {
      const auto root = parseJson(text, "f.json");
      return root ? checkVersion(root.value(), "cutis_rig", 2) : Status(root.failure());
    };
    EXPECT_OK(check(R"({"cutis_rig": 1})"));
    EXPECT_OK(check(R"({"cutis_rig": 2})"));
    EXPECT_ERROR(check(R"({"cutis_rig": 3})"), "newer version of Cutis; this one reads up to 2");
    EXPECT_ERROR(check(R"({"cutis_maps": 1})"), "does not look like the right kind of file");
    EXPECT_ERROR(check(R"({"cutis_rig": 0})"), "cutis_rig must be");
    EXPECT_ERROR(check(R"({"cutis_rig": "1"})"), "cutis_rig must be a whole number");
    EXPECT_ERROR(check(R"({"cutis_rig": 1.5})"), "cutis_rig must be a whole number");
  }

  void valuesKeepTheirDocumentAlive() {
    std::optional<JsonValue> inner;
    {
      const auto root = parseJson(R"({"a": {"b": {"c": "deep"}}})", "f.json");
      EXPECT_OK(root);
      inner = root.value().object("a").value().object("b").value();
    }
    QCOMPARE(inner->text("c").value(), std::string("deep"));
    EXPECT_ERROR(inner->number("c"), "a.b.c must be");
  }

  void depthDoesNoHarm() {
    const std::string deep(200000, '[');
    EXPECT_ERROR(parseJson("{\"a\": " + deep, "f.json"), "f.json:1:200007");
    EXPECT_OK(parseJson("{\"a\": " + deep + std::string(200000, ']') + "}", "f.json"));
  }

  void filesAreReadWithTheirName() {
    const test::ScratchFolder folder;
    const auto path = folder.write("broken.json", "{\n\"a\": 1,\n}");
    EXPECT_ERROR(readJson(path), path.string() + ":3:1: not valid JSON");
    EXPECT_ERROR(readJson(folder / "missing.json"), "there is no such file");
    EXPECT_ERROR(readJson(folder.path()), "this is a folder");
    EXPECT_ERROR(readJson(folder.write("empty.json", "")), "the file is empty");
    const auto good = readJson(folder.write("good.json", "\xEF\xBB\xBF{\"a\": 1}\r\n"));
    EXPECT_OK(good);
    EXPECT_NEAR(good.value().number("a").value(), 1.0, 0.0);
  }
};

CUTIS_TEST(JsonFileTest)

}  // namespace
}  // namespace cutis

#include "json_file_test.moc"
