#include "tests/src/images/foreign_file.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include <QFile>

namespace cutis::test {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& what) {
  std::fprintf(stderr, "fixture: %s\n", what.c_str());
  std::abort();
}

float random01(unsigned& state) {
  state = state * 1664525u + 1013904223u;
  return static_cast<float>(state >> 8) / 16777216.0f;
}

QByteArray readBytes(const fs::path& path) {
  QFile file(QString::fromStdString(path.string()));
  if (!file.open(QIODevice::ReadOnly)) fail("cannot read " + path.string());
  return file.readAll();
}

void writeBytes(const fs::path& path, const QByteArray& bytes) {
  QFile file(QString::fromStdString(path.string()));
  if (!file.open(QIODevice::WriteOnly)) fail("cannot write " + path.string());
  file.write(bytes);
}

void writeForeign(const fs::path& path, const std::string& format, const OIIO::ImageSpec& spec,
                  const std::vector<float>& samples) {
  auto output = OIIO::ImageOutput::create(format);
  if (!output || !output->open(path.string(), spec) ||
      !output->write_image(OIIO::TypeFloat, samples.data()) || !output->close()) {
    fail("cannot write " + path.string());
  }
}

void writeForeignParts(const fs::path& path, const std::vector<ForeignPart>& parts) {
  std::vector<OIIO::ImageSpec> specs;
  for (const ForeignPart& part : parts) {
    OIIO::ImageSpec spec(4, 3, static_cast<int>(part.channels.size()), OIIO::TypeHalf);
    spec.channelnames = part.channels;
    spec.alpha_channel = -1;
    if (!part.name.empty()) spec.attribute("oiio:subimagename", part.name);
    specs.push_back(spec);
  }
  auto output = OIIO::ImageOutput::create("openexr");
  const bool opened =
      specs.size() == 1 ? output->open(path.string(), specs.front())
                        : output->open(path.string(), static_cast<int>(specs.size()), specs.data());
  if (!opened) fail("cannot write " + path.string());
  for (std::size_t p = 0; p < specs.size(); ++p) {
    if (p > 0 && !output->open(path.string(), specs[p], OIIO::ImageOutput::AppendSubimage)) {
      fail("cannot write " + path.string());
    }
    std::vector<float> samples;
    for (int i = 0; i < 4 * 3; ++i) {
      for (int c = 0; c < specs[p].nchannels; ++c)
        samples.push_back(static_cast<float>(p) + 0.1f * static_cast<float>(c));
    }
    if (!output->write_image(OIIO::TypeFloat, samples.data())) fail("cannot write the samples");
  }
  if (!output->close()) fail("cannot write " + path.string());
}

namespace {

// CRC-32 of ISO 3309, as PNG annex D gives it.
std::uint32_t crcOf(const QByteArray& bytes) {
  std::uint32_t crc = 0xffffffffU;
  for (const char byte : bytes) {
    crc ^= static_cast<unsigned char>(byte);
    for (int bit = 0; bit < 8; ++bit)
      crc = (crc & 1U) != 0 ? 0xedb88320U ^ (crc >> 1) : crc >> 1;
  }
  return ~crc;
}

QByteArray bigEndian(std::uint32_t value) {
  QByteArray bytes;
  for (int shift = 24; shift >= 0; shift -= 8)
    bytes.append(static_cast<char>(value >> shift));
  return bytes;
}

}  // namespace

void addPngOrientation(const fs::path& path, int tag) {
  QByteArray content("eXIfMM\0*\0\0\0\x08\0\x01\x01\x12\0\x03\0\0\0\x01\0", 23);
  content.append(static_cast<char>(tag));
  content.append(QByteArray(6, '\0'));
  QByteArray bytes = readBytes(path);
  const QByteArray chunk = bigEndian(static_cast<std::uint32_t>(content.size() - 4)) + content +
                           bigEndian(crcOf(content));
  constexpr qsizetype kAfterHeader = 8 + 25;
  writeBytes(path, bytes.insert(kAfterHeader, chunk));
}

std::vector<float> noise(std::size_t count, unsigned seed) {
  std::vector<float> values(count);
  unsigned state = seed;
  for (float& value : values)
    value = random01(state);
  return values;
}

}  // namespace cutis::test
