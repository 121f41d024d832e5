#include "src/files/io/suggestion.h"

#include <algorithm>
#include <cctype>
#include <numeric>

#include "core/base/echoed_text.h"
#include "core/base/word_list.h"

namespace cutis {
namespace {

char lower(char c) {
  return static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
}

// Levenshtein distance, letters compared without case.
std::size_t editDistance(const std::string& a, const std::string& b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i;
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t substitution = diagonal + (lower(a[i - 1]) == lower(b[j - 1]) ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({row[j] + 1, row[j - 1] + 1, substitution});
    }
  }
  return row.back();
}

}  // namespace

std::string suggestName(const std::string& wrong, const std::vector<std::string>& known) {
  std::size_t least = wrong.size() / 2 + 1;
  std::string nearest;
  for (const std::string& name : known) {
    const std::size_t distance = editDistance(wrong, name);
    if (distance < least) {
      least = distance;
      nearest = name;
    }
  }
  const std::string list = wordList(known, ", ");
  return nearest.empty() ? "known: " + list
                         : "did you mean " + inQuotes(nearest) + "? Known: " + list;
}

}  // namespace cutis
