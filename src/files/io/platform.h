#pragma once

// What the operating systems do differently. One implementation file each.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>

namespace cutis {

// Data and metadata of a closed file are on the disk when this returns true.
bool flushToDisk(const std::filesystem::path& path);
bool folderIsWritable(const std::filesystem::path& folder);
unsigned long processId();

// Folder for what can be computed again: $XDG_CACHE_HOME/cutis or ~/.cache/cutis. Not created.
// Empty if the system names none.
std::filesystem::path cacheFolder();

// Largest memory this process ever held, or since restartPeakMemory(); 0 if the system does not
// say.
std::size_t peakMemoryBytes();
// Gives memory that was freed back to the system and begins the peak anew at what is held now,
// which is returned; nothing if the system cannot.
std::optional<std::size_t> restartPeakMemory();

// A function of a loadable part of the program, which lies in the folder of the program; null if it
// is not there. The part stays loaded.
void* moduleSymbol(const std::string& module, const char* symbol);

// Model name of the processor; may be empty.
std::string processorName();

bool standardErrorIsTerminal();

// From now on the first interrupt (Ctrl-C) or request to terminate calls `handler` on a thread of
// its own; the second ends the process with status 130. Call once.
void onInterrupt(void (*handler)());

}  // namespace cutis
