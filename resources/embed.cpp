// Build tool: embed OUTPUT.cpp ROOT FILE... writes the files' bytes as C++, named by their paths
// relative to ROOT.

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

int main(int argc, char** argv) {
  if (argc < 3) return 2;
  const std::filesystem::path root = argv[2];
  std::ofstream out(argv[1], std::ios::binary);
  out << "#include \"resources/resource_data.h\"\n\nnamespace cutis {\n\n";
  std::string table;
  for (int i = 3; i < argc; ++i) {
    const std::filesystem::path path = argv[i];
    std::ifstream in(path, std::ios::binary);
    const std::vector<unsigned char> bytes{std::istreambuf_iterator<char>(in), {}};
    if (!in && !in.eof()) {
      std::cerr << "cannot read " << path << "\n";
      return 1;
    }
    const std::string symbol = "kBytes" + std::to_string(i - 3);
    out << "static const unsigned char " << symbol << "[] = {";
    for (std::size_t k = 0; k < bytes.size(); ++k) {
      out << (k % 32 == 0 ? "\n" : "") << static_cast<int>(bytes[k]) << ',';
    }
    out << "0};\n";
    table += "    {\"" + std::filesystem::relative(path, root).generic_string() + "\", " + symbol +
             ", " + std::to_string(bytes.size()) + "},\n";
  }
  out << "\nconst ResourceData kResourceData[] = {\n"
      << table << "};\n"
      << "const unsigned kResourceCount = " << argc - 3 << ";\n\n}  // namespace cutis\n";
  return out.good() ? 0 : 1;
}
