#include <algorithm>
#include <utility>

#include "core/base/choice_place.h"
#include "src/images/color/color_statement.h"

namespace cutis {
namespace {

// In linear light. A power of 2.2 stands for sRGB in many files, which is no contradiction.
constexpr double kSameForPeople = 0.02;

std::string howItIsRead(const ColorStatement& followed, bool isConverted) {
  const std::string& name = followed.space.name;
  if (followed.source == ColorSource::choice)
    return "its colours are read as " + name + ", as chosen";
  if (followed.source == ColorSource::formatDefault)
    return "it says nothing of its colours, which are read as " + name + ", " + followed.origin;
  if (isConverted) return "its colours are converted from " + followed.origin;
  if (!followed.space.isNamed && followed.source == ColorSource::iccProfile)
    return "its colours are read by " + followed.origin;
  return "its colours are read as " + name + ", according to " + followed.origin;
}

std::string sentenceOf(const ColorStatement& followed, bool isConverted) {
  const std::string sentence = howItIsRead(followed, isConverted);
  return followed.assumption.empty() ? sentence : sentence + "; " + followed.assumption;
}

// "its ICC profile says that its colours are sRGB"
std::string said(const ColorStatement& statement) {
  if (!statement.space.isNamed && statement.source == ColorSource::iccProfile)
    return statement.origin + " describes other colours";
  return statement.origin + " says that its colours are " + statement.space.name;
}

// What another statement says against the one that is followed; empty if it agrees.
std::string contradictionOf(const ColorStatement& other, const ColorStatement& followed) {
  const bool isChosen = followed.source == ColorSource::choice;
  const std::string taken =
      (isChosen ? followed.space.name + " was chosen" : said(followed)) + " and is followed";
  if (other.space.empty())
    return other.origin + " cannot be followed (it " + other.objection + "), " + taken;
  if (differenceOf(other.space, followed.space) <= kSameForPeople) return {};
  return said(other) + ", but " + taken;
}

// What another statement says, else the default.
std::string likelySpace(const FileColors& file) {
  const auto other = std::find_if(file.statements.begin(), file.statements.end(),
                                  [](const ColorStatement& one) { return one.space.isNamed; });
  if (other == file.statements.end()) return file.byDefault.space.name;
  return other->space.name + ", as " + other->origin + " says";
}

Result<ColorStatement> chosen(const FileColors& file, const std::string& choice,
                              const std::string& place) {
  if (file.isConverted) {
    return usageError(place, "the file's colours are converted from " +
                                 file.statements.front().origin +
                                 ", and no other colour space can be chosen for them; leave the "
                                 "choice out");
  }
  CUTIS_TRY(space, namedColorSpace(choice, kColorSpaceChoice));
  return ColorStatement{ColorSource::choice, "the choice", std::move(space), {}};
}

}  // namespace

std::string ColorStatement::meaning() const {
  if (space.empty()) return objection;
  return assumption.empty() ? space.name : space.name + "; " + assumption;
}

Result<ColorDecision> decideColors(const FileColors& file, const std::string& choice,
                                   const std::string& place) {
  const auto& statements = file.statements;
  if (!statements.empty() && statements.front().source == ColorSource::storage &&
      statements.front().space.empty()) {
    return inputError(place, "the file's colours are stored as " + statements.front().objection +
                                 "; convert it to RGB");
  }
  ColorDecision decision;
  decision.followed = statements.empty() ? file.byDefault : statements.front();
  if (!choice.empty()) {
    CUTIS_TRY(statement, chosen(file, choice, place));
    decision.followed = std::move(statement);
  }
  const ColorStatement& followed = decision.followed;
  if (followed.space.empty()) {
    return inputError(place, followed.origin + " " + followed.objection +
                                 "; name the colour space of the file, for example " +
                                 likelySpace(file));
  }
  decision.sentence = sentenceOf(followed, file.isConverted);
  for (std::size_t i = choice.empty() ? 1 : 0; i < statements.size(); ++i) {
    const std::string contradiction = contradictionOf(statements[i], followed);
    if (!contradiction.empty()) decision.contradictions.push_back(contradiction);
  }
  return decision;
}

}  // namespace cutis
