#pragma once

// Files as other programs write them, through OpenImageIO itself or byte by byte.

#include <filesystem>
#include <string>
#include <vector>

#include <OpenImageIO/imageio.h>
#include <QByteArray>

namespace cutis::test {

// Ends the program: a fixture that cannot be made is no test that failed.
[[noreturn]] void fail(const std::string& what);

QByteArray readBytes(const std::filesystem::path& path);
void writeBytes(const std::filesystem::path& path, const QByteArray& bytes);

// A file as other programs write it, through OpenImageIO itself; samples are interleaved.
void writeForeign(const std::filesystem::path& path, const std::string& format,
                  const OIIO::ImageSpec& spec, const std::vector<float>& samples);
// A part of an OpenEXR file, all of whose samples are the number of the part and a tenth for each
// channel before.
struct ForeignPart {
  std::string name;
  std::vector<std::string> channels;
};
void writeForeignParts(const std::filesystem::path& path, const std::vector<ForeignPart>& parts);
// Says in a PNG file, by a chunk eXIf, how its picture lies.
void addPngOrientation(const std::filesystem::path& path, int tag);
// The next of a row of numbers in [0, 1) that is the same everywhere.
float random01(unsigned& state);
// Interleaved noise in [0, 1].
std::vector<float> noise(std::size_t count, unsigned seed = 1);

}  // namespace cutis::test
