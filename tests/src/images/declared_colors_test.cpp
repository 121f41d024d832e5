// What files say of their colours: every statement, their order, their contradictions, and what is
// written of them. Files are made byte by byte or by OpenImageIO itself.

#include <zlib.h>

#include <QtTest>

#include "src/color/icc_profile.h"
#include "src/images/capture/albedo_file.h"
#include "src/images/image_file.h"
#include "tests/src/images/image_fixture.h"
#include "tests/support/expect.h"
#include "tests/support/icc_bytes.h"
#include "tests/support/models.h"
#include "tests/support/test_registry.h"

namespace cutis {
namespace {

using test::ImageFolder;

std::string number(std::uint32_t value) {
  std::string bytes;
  test::putBytes(bytes, value, 4);
  return bytes;
}

std::string pngChunk(const std::string& name, const std::string& content) {
  const std::string body = name + content;
  const uLong crc =
      crc32(0, reinterpret_cast<const Bytef*>(body.data()), static_cast<uInt>(body.size()));
  return number(static_cast<std::uint32_t>(content.size())) + body +
         number(static_cast<std::uint32_t>(crc));
}

std::string zipped(const std::string& bytes) {
  std::string out(compressBound(static_cast<uLong>(bytes.size())), '\0');
  auto size = static_cast<uLongf>(out.size());
  compress(reinterpret_cast<Bytef*>(out.data()), &size,
           reinterpret_cast<const Bytef*>(bytes.data()), static_cast<uLong>(bytes.size()));
  out.resize(size);
  return out;
}

std::string cicp(int primaries, int transfer, int matrix = 0, int range = 1) {
  return pngChunk("cICP", {char(primaries), char(transfer), char(matrix), char(range)});
}
std::string iccp(const std::string& profile) {
  return pngChunk("iCCP", std::string("x\0\0", 3) + zipped(profile));
}
std::string srgbChunk() {
  return pngChunk("sRGB", std::string(1, '\0'));
}
std::string gamma(double value) {
  return pngChunk("gAMA", number(static_cast<std::uint32_t>(std::lround(value * 1e5))));
}
// Red, green, blue, white; stored white first.
std::string chrm(const std::array<double, 8>& c) {
  std::string content;
  for (const std::size_t i : {6u, 7u, 0u, 1u, 2u, 3u, 4u, 5u})
    content += number(static_cast<std::uint32_t>(std::lround(c[i] * 1e5)));
  return pngChunk("cHRM", content);
}

// An EXIF block, little endian: IFD0 → EXIF (ColorSpace) → interoperability (index).
std::string exifBlock(int colorSpace, const std::string& index) {
  const auto little = [](std::uint32_t value, int bytes) {
    std::string out;
    for (int i = 0; i < bytes; ++i)
      out += static_cast<char>(value >> (8 * i) & 0xff);
    return out;
  };
  const auto entry = [&](std::uint32_t tag, std::uint32_t type, std::uint32_t count,
                         const std::string& value) {
    return little(tag, 2) + little(type, 2) + little(count, 4) + value;
  };
  std::string block("II*\0", 4);
  block += little(8, 4);
  block += little(1, 2) + entry(0x8769, 4, 1, little(26, 4)) + little(0, 4);
  block += little(2, 2) + entry(0xa001, 3, 1, little(static_cast<std::uint32_t>(colorSpace), 4)) +
           entry(0xa005, 4, 1, little(56, 4)) + little(0, 4);
  block +=
      little(1, 2) + entry(1, 2, 4, (index + std::string(4, '\0')).substr(0, 4)) + little(0, 4);
  return block;
}

std::string profileOf(const RgbPrimaries& primaries, const std::string& curve,
                      const std::string& name) {
  return test::matrixProfile(4, primaries.chromaticities, curve, name);
}

class DeclaredColorsTest : public QObject {
  Q_OBJECT

  ImageFolder folder_;

  // 8-bit PNG of one grey-brown colour with these chunks.
  std::filesystem::path png(const std::string& chunks, int colorType = 2) {
    const auto path = folder_.path("a.png");
    const int channels = colorType == 2 ? 3 : 1;
    std::string rows;
    for (int y = 0; y < 4; ++y) {
      rows += '\0';
      for (int x = 0; x < 4; ++x)
        rows += std::string("\xc8\x96\x78").substr(0, static_cast<std::size_t>(channels));
    }
    const std::string head =
        number(4) + number(4) + std::string("\x08", 1) + char(colorType) + std::string(3, '\0');
    const std::string bytes = std::string("\x89PNG\r\n\x1a\n", 8) + pngChunk("IHDR", head) +
                              chunks + pngChunk("IDAT", zipped(rows)) + pngChunk("IEND", "");
    test::writeBytes(path, QByteArray::fromStdString(bytes));
    return path;
  }

  std::filesystem::path jpeg(const std::string& exif, const std::string& profile) {
    const auto path = folder_.path("a.jpg");
    OIIO::ImageSpec spec(16, 16, 3, OIIO::TypeUInt8);
    if (!profile.empty()) {
      spec.attribute("ICCProfile",
                     OIIO::TypeDesc(OIIO::TypeDesc::UINT8, static_cast<int>(profile.size())),
                     profile.data());
    }
    test::writeForeign(path, "jpeg", spec, std::vector<float>(16 * 16 * 3, 0.5f));
    if (exif.empty()) return path;
    const std::string content = std::string("Exif\0\0", 6) + exif;
    std::string segment("\xff\xe1", 2);
    test::putBytes(segment, content.size() + 2, 2);
    QByteArray bytes = test::readBytes(path);
    bytes.insert(2, QByteArray::fromStdString(segment + content));
    test::writeBytes(path, bytes);
    return path;
  }

  std::filesystem::path exr(const std::function<void(OIIO::ImageSpec&)>& say) {
    const auto path = folder_.path("a.exr");
    OIIO::ImageSpec spec(4, 4, 3, OIIO::TypeHalf);
    say(spec);
    test::writeForeign(path, "openexr", spec, std::vector<float>(48, 0.5f));
    return path;
  }

  static Result<ColorDecision> decide(const std::filesystem::path& path,
                                      const std::string& choice = {}) {
    CUTIS_TRY(header, readImageHeader(path, {}));
    return decideColors(header.colors, choice, path.string());
  }

  // The name of what is followed, and the number of contradictions if there are any.
  static std::string outcome(const std::filesystem::path& path, const std::string& choice = {}) {
    const auto decided = decide(path, choice);
    if (!decided) return decided.error().message;
    const auto against = decided.value().contradictions.size();
    return decided.value().followed.space.name +
           (against == 0 ? "" : ", against " + std::to_string(against));
  }

 private slots:
  void init() { qunsetenv("OCIO"); }

  void pngStatements_data() {
    QTest::addColumn<QByteArray>("chunks");
    QTest::addColumn<QString>("found");
    const auto row = [](const char* name, const std::string& chunks, const char* found) {
      QTest::newRow(name) << QByteArray::fromStdString(chunks) << found;
    };
    const std::string linear = test::curveTag({});
    const std::string p3 = profileOf(kP3D65, linear, "sRGB");
    const std::string rec709 = profileOf(kRec709, linear, "any");
    row("nothing", "", "sRGB");
    row("cICP sRGB", cicp(1, 13), "sRGB");
    row("cICP Display P3", cicp(12, 13), "Display P3");
    row("cICP linear Rec.2020", cicp(9, 8), "Linear Rec.2020");
    row("cICP linear P3", cicp(12, 8), "Linear P3-D65");
    row("cICP PQ", cicp(9, 16), "Rec.2100 PQ");
    row("cICP HLG", cicp(9, 18), "Rec.2100 HLG");
    row("cICP PQ of P3", cicp(12, 16), "PQ RGB of the primaries of P3-D65");
    row("cICP logarithmic", cicp(1, 10),
        "logarithmic over 2.5 decades RGB of the primaries of Rec.709");
    row("cICP reserved", cicp(1, 19),
        "its cICP chunk says the transfer characteristics 19, which are not known; name the colour "
        "space of the file, for example sRGB");
    row("cICP YCbCr", cicp(1, 13, 1),
        "its cICP chunk says luminance and chroma, which PNG files cannot hold; name the colour "
        "space of the file, for example sRGB");
    row("cICP narrow", cicp(1, 13, 0, 0), "sRGB, narrow range");
    row("cICP unspecified", cicp(2, 2), "sRGB");
    row("cICP too short", pngChunk("cICP", "ab"), "sRGB");
    row("iCCP", iccp(p3), "Linear P3-D65");
    row("sRGB", srgbChunk(), "sRGB");
    row("gAMA 1", gamma(1.0), "Linear Rec.709");
    row("gAMA 2.2", gamma(1 / 2.2), "Gamma 2.2 Rec.709");
    row("gAMA and cHRM", gamma(256.0 / 563.0) + chrm(kAdobeRgb.chromaticities), "Adobe RGB (1998)");
    row("cHRM alone", chrm(kP3D65.chromaticities), "Display P3");
    row("gAMA 0", gamma(0.0), "sRGB");
    row("cHRM of nothing", gamma(1.0) + pngChunk("cHRM", std::string(32, '\0')),
        "its gAMA chunk with cHRM says primaries that span no colours; name the colour space of "
        "the file, for example sRGB");
    row("order: cICP", cicp(12, 13) + iccp(rec709) + gamma(1.0), "Display P3, against 2");
    row("order: iCCP", iccp(p3) + gamma(1.0), "Linear P3-D65, against 1");
    row("order: sRGB", gamma(1.0) + srgbChunk(), "sRGB, against 1");
    row("libpng's usual trio", srgbChunk() + gamma(0.45455) + chrm(kRec709.chromaticities), "sRGB");
    row("order of chunks does not matter", gamma(1.0) + iccp(p3) + cicp(12, 8),
        "Linear P3-D65, against 1");
    row("eXIf Adobe", pngChunk("eXIf", exifBlock(65535, "R03")), "Adobe RGB (1998)");
    row("eXIf against sRGB", srgbChunk() + pngChunk("eXIf", exifBlock(65535, "R03")),
        "sRGB, against 1");
    row("unspecified cICP leaves room", cicp(2, 2) + gamma(1.0), "Linear Rec.709");
  }
  void pngStatements() {
    QFETCH(QByteArray, chunks);
    QFETCH(QString, found);
    QCOMPARE(QString::fromStdString(outcome(png(chunks.toStdString()))), found);
  }

  void exifStatements() {
    QCOMPARE(outcome(jpeg("", "")), std::string("sRGB"));
    QVERIFY(readImageHeader(jpeg("", ""), {}).value().colors.statements.empty());
    QCOMPARE(outcome(jpeg(exifBlock(1, "R98"), "")), std::string("sRGB"));
    QCOMPARE(outcome(jpeg(exifBlock(65535, "R03"), "")), std::string("Adobe RGB (1998)"));
    QCOMPARE(outcome(jpeg(exifBlock(65535, "R98"), "")), std::string("sRGB"));
    QCOMPARE(outcome(jpeg(exifBlock(1, "R03"), "")), std::string("sRGB, against 1"));
    const std::string p3 = profileOf(kP3D65, test::curveTag({563}), "Adobe RGB (1998)");
    QCOMPARE(outcome(jpeg("", p3)), std::string("the space of the ICC profile 'Adobe RGB (1998)'"));
    QCOMPARE(outcome(jpeg(exifBlock(65535, "R98"), p3)),
             std::string("the space of the ICC profile 'Adobe RGB (1998)'"));
    QCOMPARE(outcome(jpeg(exifBlock(1, "R98"), p3)),
             std::string("the space of the ICC profile 'Adobe RGB (1998)', against 1"));
  }

  // Every byte of the block may be wrong.
  void damagedExifIsNoStatement() {
    const std::string sound = exifBlock(65535, "R03");
    for (std::size_t at = 0; at < sound.size(); ++at) {
      std::string damaged = sound;
      damaged[at] = static_cast<char>(damaged[at] ^ 0xff);
      const std::string found = outcome(png(pngChunk("eXIf", damaged)));
      QVERIFY2(found == "sRGB" || found == "Adobe RGB (1998)", found.c_str());
    }
    QCOMPARE(outcome(png(pngChunk("eXIf", sound.substr(0, 30)))), std::string("sRGB"));
  }

  void openExrStatements() {
    const auto primaries = [](const RgbPrimaries& p) {
      return [&p](OIIO::ImageSpec& spec) {
        std::array<float, 8> values = {};
        for (std::size_t i = 0; i < 8; ++i)
          values[i] = static_cast<float>(p.chromaticities[i]);
        spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), values.data());
      };
    };
    QCOMPARE(outcome(exr([](OIIO::ImageSpec&) {})), std::string("Linear Rec.709"));
    QCOMPARE(outcome(exr(primaries(kAcesCg))), std::string("ACEScg"));
    QCOMPARE(outcome(exr(primaries(kAdobeRgb))),
             std::string("linear RGB of the primaries of Adobe RGB"));
    const auto id = [](const char* name) {
      return [name](OIIO::ImageSpec& spec) { spec.attribute("colorInteropID", name); };
    };
    for (const auto& [name, space] : {std::pair{"lin_ap1_scene", "ACEScg"},
                                      {"srgb_p3d65_scene", "Display P3"},
                                      {"lin_ap0_scene", "ACES2065-1"},
                                      {"g22_adobergb_scene", "Adobe RGB (1998)"},
                                      {"data", "Raw"},
                                      {"unknown", "Linear Rec.709"}}) {
      QCOMPARE(outcome(exr(id(name))), std::string(space));
    }
    QCOMPARE(outcome(exr(id("studio:martian"))),
             std::string("its attribute colorInteropID says 'studio:martian', which is not known; "
                         "name the colour space of the file, for example Linear Rec.709"));
    const auto aces = [](OIIO::ImageSpec& spec) { spec.attribute("acesImageContainerFlag", 1); };
    QCOMPARE(outcome(exr(aces)), std::string("ACES2065-1"));
    QCOMPARE(outcome(exr([&](OIIO::ImageSpec& spec) {
               primaries(kAcesCg)(spec);
               aces(spec);
             })),
             std::string("ACEScg, against 1"));
    QCOMPARE(outcome(exr([&](OIIO::ImageSpec& spec) {
               spec.attribute("cutis:colorspace", "ACEScg");
               primaries(kRec709)(spec);
             })),
             std::string("ACEScg, against 1"));
  }

  void choicesComeFirstAndAreHeldAgainstTheFile() {
    QCOMPARE(outcome(png(srgbChunk()), "sRGB"), std::string("sRGB"));
    const auto decided = decide(png(cicp(12, 13)), "acescg");
    EXPECT_OK(decided);
    QCOMPARE(decided.value().sentence, std::string("its colours are read as ACEScg, as chosen"));
    QCOMPARE(decided.value().contradictions.front(),
             std::string("its cICP chunk says that its colours are Display P3, but ACEScg was "
                         "chosen and is followed"));
    // A file that cannot be followed can be told what it is.
    QCOMPARE(outcome(png(cicp(1, 13, 1)), "ACEScg"), std::string("ACEScg, against 1"));
    EXPECT_ERROR(decide(png(""), "ACEScq"), "colour space: unknown colour space 'ACEScq'");
  }

  void sentencesNameWhatIsFollowed() {
    QCOMPARE(decide(png("")).value().sentence,
             std::string("it says nothing of its colours, which are read as sRGB, the default for "
                         "integers"));
    QCOMPARE(decide(png(cicp(12, 13))).value().sentence,
             std::string("its colours are read as Display P3, according to its cICP chunk"));
    QCOMPARE(decide(png(cicp(9, 16))).value().sentence,
             std::string("its colours are read as Rec.2100 PQ, according to its cICP chunk; light "
                         "of 203 cd/m² is taken as 1"));
    QCOMPARE(
        decide(png(cicp(9, 18, 0, 0))).value().sentence,
        std::string("its colours are read as Rec.2100 HLG, narrow range, according to its cICP "
                    "chunk; the scene's light at the signal 0.75 is taken as 1 and the narrow "
                    "range of video is expanded"));
    const std::string odd = profileOf(kRec2020, test::curveTag({461}), "studio");
    QCOMPARE(decide(png(iccp(odd))).value().sentence,
             std::string("its colours are read by its ICC profile 'studio'"));
    QCOMPARE(decide(png(iccp(odd) + srgbChunk())).value().contradictions.front(),
             std::string("its sRGB chunk says that its colours are sRGB, but its ICC profile "
                         "'studio' describes other colours and is followed"));
  }

  void damagedProfilesAreRefusedForTheTrueReason() {
    EXPECT_ERROR(decide(png(iccp("no profile at all, only a text"))),
                 "a.png: its ICC profile cannot be used (");
    EXPECT_ERROR(decide(png(pngChunk("iCCP", std::string("x\0\0garbage", 10)))), "cannot be used");
    EXPECT_OK(decide(png(iccp("no profile")), "sRGB"));
    const std::string odd = profileOf(kRec2020, test::curveTag({461}), "studio");
    EXPECT_ERROR(decide(png(iccp(odd.substr(0, odd.size() / 2)) + srgbChunk())),
                 "a.png: its ICC profile cannot be used (it is cut off); name the colour space of "
                 "the file, for example sRGB, as its sRGB chunk says");
    EXPECT_ERROR(
        decide(png(iccp(test::greyProfile(2, test::curveTag({461}), "dots")))),
        "a.png: its ICC profile is for grey pixels, but the picture is in colour; name the "
        "colour space of the file, for example sRGB");
  }

  void greyIsReadAsEqualColors() {
    const auto path = png(iccp(test::greyProfile(2, test::curveTag({461}), "dots")), 0);
    test::Listener listener;
    const auto albedo = readAlbedo(path, {}, test::albedoRig(), nullptr, listener.context());
    EXPECT_OK(albedo);
    QCOMPARE(albedo.value().source.channelNames, (std::vector<std::string>{"R", "G", "B"}));
    for (const Plane& plane : albedo.value().measurements.channels)
      EXPECT_NEAR(test::pixelOf(plane, 1, 1), std::pow(200.0 / 255.0, 461.0 / 256.0), 1e-3);
    QCOMPARE(listener.sentences.size(), std::size_t{2});
    QVERIFY(listener.sentences[0].ends_with("its colours are read by its ICC profile 'dots'"));
    QVERIFY(listener.sentences[1].find("the image is grey") != std::string::npos);
  }

  // What is written says what it is, and says nothing that is not so.
  void outputsStateTheirColors_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("space");
    for (const char* file : {"o.png", "o.jpg", "o.tif", "o.exr"}) {
      for (const char* space : {"sRGB", "Linear Rec.709", "Display P3", "Adobe RGB (1998)",
                                "ACEScg", "Linear Rec.2020"})
        QTest::addRow("%s %s", file, space) << file << space;
    }
  }
  void outputsStateTheirColors() {
    QFETCH(QString, file);
    QFETCH(QString, space);
    const auto path = folder_.path(file.toStdString());
    ImageContent content = test::makeContent(8, 8, {"R", "G", "B"});
    content.colorSpace = builtInColorSpace(space.toStdString());
    // A source that says many things which are no longer true.
    content.metadata = readImageHeader(exr([](OIIO::ImageSpec& spec) {
                                         spec.attribute("acesImageContainerFlag", 1);
                                         spec.attribute("colorInteropID", "lin_ap0_scene");
                                         spec.attribute("Exif:ColorSpace", 1);
                                         spec.attribute("oiio:Gamma", 1.8f);
                                         spec.attribute("Make", "Canon");
                                       }),
                                       {})
                           .value()
                           .metadata;
    const SampleType type = file.endsWith("exr") ? SampleType::half : SampleType::uint8;
    test::Listener listener;
    EXPECT_OK(writeImage(path, content, type, listener.context()));
    QVERIFY(listener.sentences.empty());
    const auto header = readImageHeader(path, {});
    EXPECT_OK(header);
    const auto decided = decideColors(header.value().colors, {}, "out");
    EXPECT_OK(decided);
    QCOMPARE(QString::fromStdString(decided.value().followed.space.name), space);
    QVERIFY(!header.value().colors.statements.empty());
    QVERIFY2(decided.value().contradictions.empty(),
             decided.value().contradictions.empty()
                 ? ""
                 : decided.value().contradictions.front().c_str());
    auto input = OIIO::ImageInput::open(path.string());
    QVERIFY(input != nullptr);
    for (const char* stale : {"acesImageContainerFlag", "colorInteropID"})
      QVERIFY(input->spec().find_attribute(stale) == nullptr);
    QCOMPARE(header.value().metadata.text("Make").value_or(""), std::string("Canon"));
    std::vector<unsigned char> pixels(8 * 8 * 3);
    QVERIFY(input->read_image(0, 0, 0, -1, OIIO::TypeUInt8, pixels.data()));
  }

  // What code points said is said by the same code points again; no profile has such curves.
  void codePointsAreStatedAgain() {
    for (const std::string& chunk :
         {cicp(9, 16), cicp(9, 18), cicp(12, 16), cicp(1, 13, 0, 0), cicp(9, 18, 0, 0)}) {
      const auto read = decide(png(chunk));
      EXPECT_OK(read);
      const ColorSpace& space = read.value().followed.space;
      ImageContent content = test::makeContent(8, 8, {"R", "G", "B"});
      content.colorSpace = space;
      test::Listener listener;
      EXPECT_OK(writeImage(folder_.path("o.png"), content, SampleType::uint8, listener.context()));
      QVERIFY(listener.sentences.empty());
      QVERIFY(test::readBytes(folder_.path("o.png")).contains(QByteArray::fromStdString(chunk)));
      QCOMPARE(decide(folder_.path("o.png")).value().followed.space.name, space.name);
      QVERIFY(!canStateColors("o.tif", SampleType::uint8, space));
      QVERIFY(!canStateColors("o.jpg", SampleType::uint8, space));
      // Black and white have other numbers in 16 bits.
      const bool isNarrow = space.name.ends_with("narrow range");
      QCOMPARE(canStateColors("o.png", SampleType::uint16, space), !isNarrow);
    }
  }

  void profilesOfTheSourceAreEmbeddedAgain() {
    const std::string profile =
        profileOf(kRec2020, test::sampledTag(256, [](double v) { return v * v; }), "studio");
    for (const char* file : {"o.png", "o.jpg", "o.tif"}) {
      ImageContent content = test::makeContent(8, 8, {"R", "G", "B"});
      content.colorSpace = readIccProfile(profile, "a").value().space;
      EXPECT_OK(writeImage(folder_.path(file), content, SampleType::uint8, {}));
      const auto header = readImageHeader(folder_.path(file), {});
      EXPECT_OK(header);
      const ColorStatement& first = header.value().colors.statements.front();
      QVERIFY(first.space.profile != nullptr && *first.space.profile == profile);
    }
    const ColorSpace studio = readIccProfile(profile, "a").value().space;
    QVERIFY(!canStateColors("o.exr", SampleType::half, studio));
    QVERIFY(canStateColors("o.exr", SampleType::half, builtInColorSpace("sRGB")));
  }
};

CUTIS_TEST(DeclaredColorsTest)

}  // namespace
}  // namespace cutis

#include "declared_colors_test.moc"
