#include "ui/commands/command_search.h"

#include <algorithm>
#include <utility>

#include <QStringList>

#include "ui/commands/command_registry.h"

namespace cutis {
namespace {

constexpr int kWordBegins = 100;
constexpr int kWithinWord = 60;
constexpr int kLettersLeftOut = 30;
constexpr int kInSurroundings = 10;
// Fewer letters are found in order almost anywhere.
constexpr int kFewestScattered = 3;

// Without case and accents.
QString folded(const QString& text) {
  QString plain;
  for (const QChar c : text.normalized(QString::NormalizationForm_D).toCaseFolded()) {
    if (c.category() != QChar::Mark_NonSpacing) plain += c;
  }
  return plain;
}

bool beginsWordOf(const QString& text, qsizetype place) {
  return place == 0 || !text[place - 1].isLetterOrNumber();
}

int qualityOfWord(const QString& word, const QString& name) {
  int best = 0;
  for (auto at = name.indexOf(word); at >= 0; at = name.indexOf(word, at + 1))
    best = std::max(best, beginsWordOf(name, at) ? kWordBegins : kWithinWord);
  return best;
}

// The letters of the word in their order, from the beginning of a word on.
bool isScatteredIn(const QString& word, const QString& name) {
  if (word.size() < kFewestScattered) return false;
  for (auto start = name.indexOf(word[0]); start >= 0; start = name.indexOf(word[0], start + 1)) {
    if (!beginsWordOf(name, start)) continue;
    qsizetype found = 1;
    for (qsizetype at = start + 1; at < name.size() && found < word.size(); ++at)
      found += name[at] == word[found] ? 1 : 0;
    if (found == word.size()) return true;
  }
  return false;
}

}  // namespace

int matchQuality(const QString& query, const QString& name, const QString& surroundings) {
  const QString where = folded(name), about = folded(surroundings);
  int total = 1;
  for (const QString& word : folded(query).split(' ', Qt::SkipEmptyParts)) {
    int quality = qualityOfWord(word, where);
    if (quality == 0 && isScatteredIn(word, where)) quality = kLettersLeftOut;
    if (quality == 0 && about.contains(word)) quality = kInSurroundings;
    if (quality == 0) return 0;
    total += quality;
  }
  return total;
}

std::vector<const CommandDescription*> findCommands(const CommandRegistry& commands,
                                                    const QString& query) {
  std::vector<std::pair<int, const CommandDescription*>> found;
  for (const CommandDescription& command : commands.all()) {
    const int quality = matchQuality(query, commands.nameOf(command),
                                     CommandRegistry::placeOf(command) + ' ' + command.toolTip);
    if (quality > 0) found.emplace_back(quality, &command);
  }
  std::stable_sort(found.begin(), found.end(),
                   [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<const CommandDescription*> best;
  for (const auto& [quality, command] : found)
    best.push_back(command);
  return best;
}

}  // namespace cutis
