#pragma once  // internal to ui/commands

// Finds commands by what people type of them.

#include <vector>

#include <QString>

namespace cutis {

class CommandRegistry;
struct CommandDescription;

// How well the words of the query, in any order, are found in `name`: at the beginning of a word,
// within one, or with letters left out. Words that are not there are looked for in `surroundings`
// (the menu, the tool tip), where they count little. 0: one of the words is nowhere; an empty query
// finds everything alike.
int matchQuality(const QString& query, const QString& name, const QString& surroundings);

// The commands that match, the best first, equal ones in the order of the table.
std::vector<const CommandDescription*> findCommands(const CommandRegistry& commands,
                                                    const QString& query);

}  // namespace cutis
