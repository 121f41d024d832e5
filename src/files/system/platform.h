#pragma once

// What the operating systems do differently. One implementation file each.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace cutis {

// Data and metadata of a closed file are on the disk when this returns true.
bool flushToDisk(const std::filesystem::path& path);
// Whether this process may write to a file, or make files in a folder.
bool isWritable(const std::filesystem::path& path);
// A new, empty file that only its owner may read. False if there is something of this name.
bool createPrivateFile(const std::filesystem::path& path);
// Gives `to` the mode of `from` (without the bits that run a program as somebody else) and, where
// the system lets us, its owner, group, access list and extended attributes. Where the group cannot
// be kept, it may do no more than everybody.
void keepAttributes(const std::filesystem::path& from, const std::filesystem::path& to);
unsigned long processId();
bool isProcessAlive(unsigned long id);

// Folder for what can be computed again: $XDG_CACHE_HOME/cutis or ~/.cache/cutis. Not created.
// Empty if the system names none.
std::filesystem::path cacheFolder();

// Folder for what a crash must not take: $XDG_STATE_HOME/cutis or ~/.local/state/cutis. Not
// created. Empty if the system names none.
std::filesystem::path stateFolder();

// Largest memory this process ever held, or since restartPeakMemory(); 0 if the system does not
// say.
std::size_t peakMemoryBytes();
// Gives memory that was freed back to the system and begins the peak anew at what is held now,
// which is returned; nothing if the system cannot.
std::optional<std::size_t> restartPeakMemory();

// A function of a loadable part of the program, which lies beside the program, or in
// ../lib/cutis/modules where it is installed; null if it is not there. The part stays loaded.
void* moduleSymbol(const std::string& module, const char* symbol);

// Model name of the processor; may be empty.
std::string processorName();

bool standardErrorIsTerminal();

}  // namespace cutis
