// The rules on made-up snippets: that they let through what they should, and that they can fail.

#include "tests/architecture/house_rules.h"

#include <QtTest>

#include "tests/support/test_registry.h"

namespace cutis::test {
namespace {

std::string moduleOf(const std::string& header) {
  if (header == "QString" || header == "QtCore/QObject" || header == "QObject") return "QtCore";
  if (header == "QImage" || header == "QtGui/QImage") return "QtGui";
  if (header == "QWidget") return "QtWidgets";
  return {};
}

std::string included(const char* path, const char* name) {
  const bool own = std::string(name).find('<') == std::string::npos;
  const std::string line = own ? std::string("\"") + name + "\"" : std::string(name);
  const auto violations = checkIncludes({{path, "#include " + line + "\n"}}, moduleOf);
  return violations.empty() ? std::string() : violations.front();
}

class HouseRulesTest : public QObject {
  Q_OBJECT

 private slots:
  void includesAreFound() {
    const auto includes = includesOf(
        "#pragma once\n"
        "#include \"core/base/rect.h\"\n"
        "  #  include <vector>  // why\n"
        "// #include \"core/fit/no.h\"\n"
        "/* #include <no>\n#include <neither>\n*/ int x;\n"
        "#include <QtTest>\n"
        "const char* s = \"#include <no>\";\n");
    QCOMPARE(includes.size(), std::size_t{3});
    QCOMPARE(includes[0].name, std::string("core/base/rect.h"));
    QCOMPARE(includes[0].line, 2);
    QVERIFY(!includes[0].angled);
    QCOMPARE(includes[1].name, std::string("vector"));
    QVERIFY(includes[1].angled);
    QCOMPARE(includes[2].line, 8);
  }

  void foldersAreRooms() {
    QCOMPARE(folderOf("core/skin/profile/profile.h"), std::string("core/skin"));
    QCOMPARE(folderOf("core/skin/deep/er.h"), std::string("core/skin"));
    QCOMPARE(folderOf("ui/docks/plot.h"), std::string("ui"));
    QCOMPARE(folderOf("resources/resource_data.h"), std::string("resources"));
    QCOMPARE(folderOf("profile.h"), std::string());
    QCOMPARE(folderOf("core/CMakeLists.txt"), std::string());
    QCOMPARE(folderOf("hwy/highway.h"), std::string());
  }

  void coreRunsDownwards() {
    const char* chain[] = {"core/base", "core/spectra", "core/skin", "core/rig", "core/fit"};
    for (int from = 0; from < 5; ++from) {
      for (int to = 0; to < 5; ++to)
        QCOMPARE(mayUse(chain[from], chain[to]), to <= from);
    }
    for (const char* beside : {"core/edit", "core/render"}) {
      QVERIFY(mayUse(beside, "core/base") && mayUse(beside, "core/spectra"));
      QVERIFY(mayUse(beside, "core/skin"));
      QVERIFY(!mayUse(beside, "core/rig") && !mayUse(beside, "core/fit"));
      QVERIFY(!mayUse(beside, "core/simulate"));
      for (const char* link : chain)
        QVERIFY(!mayUse(link, beside));
    }
    QVERIFY(!mayUse("core/edit", "core/render") && !mayUse("core/render", "core/edit"));
    QVERIFY(mayUse("core/simulate", "core/rig") && mayUse("core/simulate", "core/render"));
    for (const char* link : chain)
      QVERIFY(!mayUse(link, "core/simulate"));
    QVERIFY(!mayUse("core/fit", "src/files") && !mayUse("core/base", "resources"));
  }

  void sourceRunsDownwards() {
    QVERIFY(mayUse("src/files", "core/fit") && mayUse("src/files", "resources"));
    for (const char* reader : {"src/images", "src/color", "src/register", "src/report"}) {
      QVERIFY(mayUse(reader, "src/files") && mayUse(reader, "core/simulate"));
      QVERIFY(!mayUse("src/files", reader));
      QVERIFY(!mayUse(reader, "src/app") && !mayUse(reader, "ui") && !mayUse(reader, "src/cli"));
      QVERIFY(mayUse("src/app", reader) && mayUse("src/cli", reader));
    }
    QVERIFY(!mayUse("src/images", "src/color"));
    QVERIFY(mayUse("src/cli", "src/app") && !mayUse("src/app", "src/cli"));
    QVERIFY(mayUse("src/cli", "src/bench") && mayUse("src/bench", "src/app"));
    QVERIFY(!mayUse("src/bench", "src/cli") && !mayUse("src/bench", "ui"));
    QVERIFY(!mayUse("src/app", "src/bench") && !mayUse("ui", "src/bench"));
    QVERIFY(!mayUse("src/cli", "ui") && !mayUse("src/app", "ui"));
    for (const char* below :
         {"src/app", "src/files", "src/images", "src/color", "src/report", "core/base"}) {
      QVERIFY(mayUse("ui", below));
    }
    QVERIFY(!mayUse("ui", "src/register") && !mayUse("ui", "src/cli") &&
            !mayUse("ui", "src/cutis"));
    QVERIFY(mayUse("src/cutis", "ui") && mayUse("src/cutis", "src/app"));
    QVERIFY(!mayUse("src/app", "tests") && !mayUse("core/base", "tests"));
  }

  void strangersHaveNoPlace() {
    QVERIFY(!mayUse("core/extra", "core/base") && !mayUse("src/files", "core/extra"));
    QVERIFY(!mayUse("src/extra", "core/base") && !mayUse("src/app", "src/extra"));
  }

  void wrongIncludesAreReported() {
    QCOMPARE(included("core/spectra/a.h", "core/skin/profile/profile.h"),
             std::string("core/spectra/a.h:1: core/spectra may not include core/skin"));
    QVERIFY(!included("core/fit/a.cpp", "src/files/io/csv.h").empty());
    QVERIFY(!included("core/fit/a.cpp", "tests/support/expect.h").empty());
    QVERIFY(!included("src/files/a.cpp", "csv.h").empty());
    QVERIFY(!included("src/files/a.cpp", "../files/csv.h").empty());
    QVERIFY(included("src/files/a.cpp", "src/files/io/csv.h").empty());
    QVERIFY(included("src/files/a.cpp", "core/fit/table/skin_table.h").empty());
    QVERIFY(included("ui/a.cpp", "a.moc").empty());
  }

  void librariesHaveTheirRooms() {
    QVERIFY(!included("core/base/a.h", "<QString>").empty());
    QVERIFY(!included("core/base/a.h", "<qglobal.h>").empty());
    QVERIFY(included("core/base/a.h", "<queue>").empty());
    QVERIFY(included("core/base/a.h", "<Eigen/Core>").empty());
    QVERIFY(!included("core/skin/a.h", "<OpenImageIO/imageio.h>").empty());
    QVERIFY(!included("src/files/a.h", "<OpenImageIO/imageio.h>").empty());
    QVERIFY(!included("src/color/a.h", "<OpenImageIO/imageio.h>").empty());
    QVERIFY(included("src/images/a.h", "<OpenImageIO/imageio.h>").empty());
    QVERIFY(!included("src/images/a.h", "<OpenColorIO/OpenColorIO.h>").empty());
    QVERIFY(included("src/color/a.h", "<OpenColorIO/OpenColorIO.h>").empty());
    QVERIFY(included("src/app/a.h", "<QString>").empty());
    QVERIFY(included("src/app/a.h", "<QtCore/QObject>").empty());
    QVERIFY(!included("src/app/a.h", "<QImage>").empty());
    QVERIFY(!included("src/app/a.h", "<QtGui/QImage>").empty());
    QVERIFY(!included("src/app/a.h", "<QUnknown>").empty());
    QVERIFY(included("src/report/a.h", "<QImage>").empty());
    QVERIFY(!included("src/report/a.h", "<QWidget>").empty());
    QVERIFY(included("ui/a.h", "<QWidget>").empty());
  }

  void eigenIsFoundHoweverFarAway() {
    const SourceTree tree = {
        {"core/skin/far.h", "#include <Eigen/Core>\n"},
        {"core/skin/near.h", "#include \"core/skin/far.h\"\n"},
        {"core/skin/plain.h", "#include \"core/skin/plain.h\"\n#include <array>\n"},
        {"core/skin/bad.cpp", "#include <hwy/foreach_target.h>\n#include \"core/skin/near.h\"\n"},
        {"core/skin/bad-inl.h", "#include \"core/skin/near.h\"\n"},
        {"core/skin/direct-inl.h", "#include <Eigen/Core>\n"},
        {"core/skin/good.cpp", "#include <hwy/foreach_target.h>\n#include \"core/skin/plain.h\"\n"},
        {"core/skin/free.cpp", "#include \"core/skin/near.h\"\n"},
    };
    const auto violations = checkVectorised(tree);
    QCOMPARE(violations.size(), std::size_t{3});
    QVERIFY(violations[1].find("bad.cpp → core/skin/near.h → core/skin/far.h → <Eigen/Core>") !=
            std::string::npos);
  }

  void wrongLinksAreReported() {
    QVERIFY(checkLinks("core/base: | TBB::tbb\ncore/skin: core/base core/spectra | hwy\n").empty());
    QVERIFY(checkLinks("src/app: core/fit src/images | Qt6::Core\n").empty());
    QVERIFY(checkLinks("src/images: core/base | PkgConfig::OpenImageIO\n").empty());
    for (const char* bad :
         {"core/skin: core/fit", "core/edit: core/base core/rig", "src/files: src/images",
          "core/base: | Qt6::Core", "src/files: | PkgConfig::OpenImageIO",
          "src/images: | PkgConfig::OpenColorIO", "src/app: | Qt6::Core Qt6::Gui",
          "src/report: | Qt6::Widgets", "core/new: core/base", "nonsense"}) {
      QCOMPARE(checkLinks(bad).size(), std::size_t{1});
    }
  }

  void styleIsChecked() {
    const std::string word = std::string("TO") + "DO";
    QVERIFY(checkStyle("a.h", "int x;\n").empty());
    QCOMPARE(checkStyle("a.h", "int x;\n\tint y;\n").front(), std::string("a.h:2: a tab"));
    QVERIFY(!checkStyle("a.h", "// " + word + ": later\n").empty());
    QVERIFY(!checkStyle("a.h", std::string("// X") + "XX\n").empty());
    QVERIFY(checkStyle("a.h", "path = \"cutis-XXXXXX\"; // " + word + "S\n").empty());
    std::string longText;
    for (int i = 0; i < kMaximumLines; ++i)
      longText += "\n";
    QVERIFY(checkStyle("a.h", longText).empty());
    QCOMPARE(checkStyle("a.h", longText + "\n").size(), std::size_t{1});
  }
};

CUTIS_TEST(HouseRulesTest)

}  // namespace
}  // namespace cutis::test

#include "house_rules_test.moc"
